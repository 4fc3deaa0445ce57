// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

#include "gestalt/core/scene/frame.h"
#include "gestalt/core/scene/moments.h"
#include "gestalt/core/scene/surface_set.h"

namespace gestalt {

/// An even sample of a surface's points. Every point stands for `pixels / points.size()` pixels.
struct Cloud {
  std::vector<Eigen::Vector3f> points;
  double pixels = 0;

  /// 1/z^2 averaged over the points, times pixels: what is within reach of the camera outweighs the room behind it.
  double weight = 0;
};

/// Of every surface; without points when most of them are farther away than max_depth metres (0: none is).
std::vector<Cloud> sample_surfaces(const Frame& frame, const SurfaceSet& surfaces, double max_depth);

struct Plane {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = -Eigen::Vector3d::UnitZ();  // towards the camera

  /// Positive on the camera's side.
  double distance(const Eigen::Vector3f& p) const { return normal.dot(p.cast<double>() - point); }
};

/// Shares of a surface's points relative to a sheet.
struct Position {
  double within = 0;
  double before = 0;       ///< on the camera's side
  double before_hull = 0;  ///< those over the sheet's hull
  double behind = 0;
};

/// Coplanar surfaces, and the hull around them.
class Sheet {
 public:
  Plane plane;
  std::vector<int> surfaces;
  double pixels = 0;
  double weight = 0;     ///< of its clouds
  double area = 0;       ///< m^2
  double diameter = 0;   ///< m, of the hull
  double tolerance = 0;  ///< sigma(z); points nearer to the plane than this times sigma(z) lie in it

  /// Whether most points of a surface lie in the plane, and its mean half as near: noise averages out, the bottom of a
  /// bowl stays above the table.
  bool has(const Cloud& cloud, const DepthNoise& noise) const;

  /// Whether a point lies over the hull, or outside none of its edges by more than margin metres.
  bool holds(const Eigen::Vector3f& p, double margin) const;

  /// Extent of the hull in a direction, metres.
  double extent(const Eigen::Vector3d& direction) const;

  Position position(const Cloud& cloud, const DepthNoise& noise, double margin) const;

 private:
  friend class SheetSearch;
  void enclose(const std::vector<Cloud>& clouds);
  cv::Point2f in_plane(const Eigen::Vector3f& p) const;

  Eigen::Vector3d first_axis_, second_axis_;
  struct Edge {
    cv::Point2f outward;  // unit normal
    float offset;
  };
  std::vector<cv::Point2f> corners_;
  std::vector<Edge> edges_;
};

/// The planes that a frame's surfaces lie in, largest area first; points nearer to one than tolerance times sigma(z),
/// or than a rough one's own points, lie in it.
std::vector<Sheet> find_sheets(const Frame& frame, const std::vector<Cloud>& clouds, double tolerance);

}  // namespace gestalt
