// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "gestalt/core/base/export.h"
#include "gestalt/core/pipeline/segmenter.h"

namespace gestalt {

/// A box around points, metres, camera frame.
struct OrientedBox {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  /// Columns are the unit axes of a right-handed frame: the third is the normal of the support, or, without one, of the
  /// object's largest surface, the first the longer side of the smallest rectangle around the rest.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Eigen::Vector3d size =
      Eigen::Vector3d::Zero();  ///< along the axes; of what is seen, without half a per cent at either end
};

/// The background plane that an object stands on, hangs at or lies before.
struct Support {
  int patch = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, towards the camera
  double offset = 0;                                 ///< metres; points of the plane have normal . p = offset
  double bottom = 0, top = 0;  ///< metres over the plane, of the object's lowest and highest points that are seen
};

/// A plane part of an object's surface.
struct Face {
  int patch = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< metres
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, towards the camera
  double area = 0;                                   ///< square metres, of what is seen
};

enum class ShapeKind { plane, box, cylinder, sphere, other };

/// "plane", "box", "cylinder", "sphere" or "other".
GESTALT_EXPORT std::string_view name_of(ShapeKind kind);

struct Colour {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero(), deviation = Eigen::Vector3d::Zero();  ///< red green blue, 0 to 255
};

/// A pair of patches whose decision was close.
struct Doubt {
  int a = 0, b = 0;
  double probability = 0;  ///< that both belong to one object
};

/// An object in figures. Sizes are of what the camera sees.
struct ObjectDescription {
  int label = 0;                                       ///< of the segment
  int pixels = 0;                                      ///< of the segment
  cv::Rect box;                                        ///< of the segment's pixels
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< mean of the points, metres
  OrientedBox oriented_box;
  std::optional<Support> support;
  ShapeKind kind = ShapeKind::other;  ///< a hint; other where no shape fits to the noise of depth
  std::optional<Face> largest_face;
  std::optional<Colour> colour;  ///< none for frames without colour
  double confidence = 0;         ///< probability that the segment is one whole object (docs/objects.md)
  std::vector<Doubt> joins;      ///< joins within the object of which p is low, the lowest first, at most three
  std::vector<Doubt> cuts;       ///< cuts to other objects of which p is high, the highest first, at most three
};

/// Every segment that is an object, by label. Costs a pass over the objects' pixels. The result is the same for any
/// number of threads.
GESTALT_EXPORT std::vector<ObjectDescription> describe_objects(const SegmentedFrame& found);

}  // namespace gestalt
