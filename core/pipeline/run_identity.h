// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "gestalt/core/config/loaded_config.h"

namespace gestalt {

/// Names what the results of all scenes follow from, by its content: this build, the config but its time budget, the
/// model, the libraries of the components that the config names. Equal for configs that lie elsewhere with the same
/// content. Throws ModelError for a model that cannot be read.
GESTALT_EXPORT std::string run_identity(const LoadedConfig& loaded);

}  // namespace gestalt
