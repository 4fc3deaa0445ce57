// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gestalt/io/scene/input.h"

namespace gestalt {

// What is done where there is no colour and no config was asked for. A frame by itself takes the config and model for
// depth alone; of scenes that are trained on or scored together all take it or none, as their numbers are compared.

/// configs/depth_only.yaml, beside default_config().
GESTALT_EXPORT std::filesystem::path depth_only_config();

/// Whether a user asked for nothing that it would replace: no config (empty), and no model, relation or classifier in
/// the overrides (path=value).
GESTALT_EXPORT bool depth_only_may_replace(const std::filesystem::path& config,
                                           const std::vector<std::string>& overrides);

/// Whether none of the scenes that can be read has colour; false without such a scene. Reads them one by one up to the
/// first that has some.
GESTALT_EXPORT bool none_has_colour(const std::vector<std::filesystem::path>& scenes, const ReadOptions& options);

/// Throws InputError for a scene without colour whose set has scenes with it: neither config does for all of them.
GESTALT_EXPORT void require_colour_as_of_others(const Input& input);

}  // namespace gestalt
