// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "component_call.h"
#include "gestalt/core/scene/frame.h"
#include "gestalt/core/scene/patch_map.h"

namespace gestalt {

// What is asked of a component's result before it is used, so that a plugin that breaks its contract is an error with
// its name and nothing worse. Each throws PluginError.

/// PatchMap's contract, but that every label is in use.
void require_patches(ComponentName clusterer, const PatchMap& patches, const Frame& frame);

/// A group for each of the nodes, 0 or above and below their number.
void require_groups(ComponentName solver, const std::vector<int>& groups, std::size_t nodes);

/// All in [0, 1].
void require_probabilities(ComponentName classifier, std::span<const double> p);

}  // namespace gestalt
