// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "gestalt/core/base/export.h"
#include "gestalt/core/scene/graph.h"
#include "gestalt/core/scene/role.h"

namespace gestalt {

/// One object hypothesis, or a piece of the background.
struct Segment {
  std::vector<int> surfaces;  ///< indices into SurfaceSet::surfaces, ascending
  int pixel_count = 0;
  Role role = Role::object;  ///< of the most pixels; object when they tie
};

/// The global decision. Segments are numbered by their label: segment i has label i + 1 in the image.
struct Segmentation {
  cv::Mat_<std::uint16_t> labels;  ///< size of the frame; 0 = no segment
  std::vector<Segment> segments;   ///< largest first
  Graph graph;
};

/// The label image with background at 0; what is left keeps its label.
GESTALT_EXPORT cv::Mat_<std::uint16_t> object_labels(const Segmentation& segmentation);

}  // namespace gestalt
