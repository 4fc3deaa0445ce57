// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "gestalt/core/plugin/fitter.h"

namespace gestalt {

/// The fitter of a plugin with what it and its surfaces answer looked at: what they throw, and numbers that are not
/// finite or are negative where they may not be, is a PluginError that names it. Otherwise it would show first in a
/// relation, which would be blamed. Its surfaces are of their fitter's type(), but not of its class.
GESTALT_EXPORT std::shared_ptr<const Fitter> checked_fitter(std::shared_ptr<const Fitter> fitter,
                                                            const std::string& plugin);

}  // namespace gestalt
