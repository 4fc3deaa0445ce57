// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gestalt/export.h"
#include "gestalt/parametric_surface.h"

namespace gestalt {

/// The surfaces of a segmented scene, as `gestalt segment` has stored them.
struct StoredResult {
  struct Segment {
    int label = 0;
    bool background = false;  ///< by its role; a segment without a role is an object
    std::vector<int> patches;
  };

  std::string scene;
  std::vector<Segment> segments;
  std::vector<TrimmedSurface> patches;
};

/// Reads a result.json, which may come from a stranger: everything in it is checked before it is used. Throws
/// InputError naming the file, the place in it, what is wrong there and the remedy.
GESTALT_EXPORT StoredResult read_result(const std::filesystem::path& file);

}  // namespace gestalt
