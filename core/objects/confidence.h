// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "gestalt/core/objects/object_description.h"

namespace gestalt {

/// What the graph says about a segment.
struct Certainty {
  double confidence = 0;
  std::vector<Doubt> joins, cuts;
};

/// Of every segment, by label - 1; background has none. pixel_density: of the camera.
///
/// Confidence is a logistic function of four numbers: the weakest join of the maximum spanning tree of the segment's
/// inner edges (joins that hold less than a fiftieth of the pixels do not count); the largest mean p of its edges to
/// another object, each edge weighted by its smaller patch; the number of patches; and of pixels. Its coefficients were
/// fitted to whether an object's F exceeds 0.75 on scenes that the model had not seen (docs/objects.md).
GESTALT_EXPORT std::vector<Certainty> find_certainties(const Segmentation& segmentation, double pixel_density);

}  // namespace gestalt
