// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "gestalt/core/base/export.h"
#include "gestalt/core/scene/outline.h"

namespace gestalt {

/// Points in blocks of eight that follow each other, with a box around each block: distances are computed only for
/// blocks whose boxes leave open whether they matter, eight at once. Points that follow each other should lie near each
/// other, as those of an outline do; results are those of a look at all pairs, to the last bit.
class GESTALT_EXPORT PointBlocks {
 public:
  static constexpr int size = 8;  ///< points of a block

  /// Points are columns, at least one, and finite.
  explicit PointBlocks(const Eigen::Matrix3Xf& points);

  int count() const { return count_; }
  int blocks() const { return int(coordinates_.size()) / (3 * size); }

  /// x of the eight points, their y, their z. The last block repeats the last point.
  const float* block(int i) const { return coordinates_.data() + std::ptrdiff_t{3} * size * i; }

  /// Of blocks 8 i to 8 i + 7: least x of each, largest x of each, the same of y and z. Boxes of blocks that there are
  /// not are inside out: least is infinite, largest is minus infinite.
  const float* boxes(int i) const { return boxes_.data() + std::ptrdiff_t{6} * size * i; }

 private:
  int count_;
  std::vector<float> coordinates_;
  std::vector<float> boxes_;
};

/// The smallest squared distance of a point of one and a point of the other.
GESTALT_EXPORT float smallest_squared_distance(const PointBlocks& a, const PointBlocks& b);

/// The largest.
GESTALT_EXPORT float largest_squared_distance(const PointBlocks& a, const PointBlocks& b);

/// As nearest_points() of the columns that they were made of.
GESTALT_EXPORT std::vector<NearestPoint> nearest_points(const PointBlocks& from, const PointBlocks& to, double share);

}  // namespace gestalt
