// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gestalt/core/base/export.h"
#include "gestalt/io/result/parametric_surface.h"

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
  std::string warning;  ///< of files that lie beside it and are of another run; "" where there are none
};

/// Reads a result.json, which may be untrusted: everything in it is checked before it is used. Throws
/// InputError naming the file, the place in it, what is wrong there and the remedy.
GESTALT_EXPORT StoredResult read_result(const std::filesystem::path& file);

/// The surfaces of a segment's patches as one mesh, as triangulate() makes those of one (tolerance in m). Throws
/// InputError naming the patch.
GESTALT_EXPORT Mesh triangulate(const StoredResult& result, const StoredResult::Segment& segment, double tolerance,
                                TriangulationBudget& budget);

/// The content of a result.json: an object of this format and version; nothing else in it is checked. Throws InputError
/// as read_result() does.
GESTALT_EXPORT nlohmann::json read_result_content(const std::filesystem::path& file);

/// The surface of an element of "patches". Throws ModelError for damage, and for a shape that is not known here.
GESTALT_EXPORT TrimmedSurface read_surface(const nlohmann::json& patch);

}  // namespace gestalt
