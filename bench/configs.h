// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gestalt/core/pipeline/segmenter.h"

namespace gestalt::bench {

/// The file of a config that comes with Gestalt, by its name without extension.
std::filesystem::path bundled_config(const std::string& name);

/// The names of the configs that are timed: default, realtime and paper, as far as they are installed.
std::vector<std::string> measured_configs();

}  // namespace gestalt::bench
