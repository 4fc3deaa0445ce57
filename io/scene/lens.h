// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "gestalt/core/base/export.h"
#include "gestalt/core/scene/frame.h"

namespace gestalt {

/// How a lens moves points of the image plane at z = 1, as camera calibrations tell it.
struct Lens {
  enum class Model {
    radial_tangential,  ///< k1 k2 p1 p2 k3 k4 k5 k6, then thin prism s1 to s4: OpenCV, plumb_bob and rational of ROS
    equidistant         ///< k1 k2 k3 k4 of a fisheye lens: equidistant of ROS and kalibr, OpenCV's cv::fisheye
  };
  Model model = Model::radial_tangential;
  std::vector<double> coefficients;  ///< of the model, in that order; what is missing is 0

  /// Whether it moves any point.
  GESTALT_EXPORT bool distorts() const;

  /// Where a point of the undistorted plane is seen.
  cv::Point2d distorted(cv::Point2d point) const;

  /// The radius in that plane up to which the lens is known, at most the given one: beyond, a larger radius would be
  /// seen nearer to the centre, which is a polynomial's doing and no lens's.
  double largest_radius(double most) const;
};

/// The largest radius of the camera's image in the plane at z = 1.
double largest_radius_of(const Camera& camera);

/// The largest distance in pixels between where a ray is seen and where it would be without the lens, over the image
/// without it; infinite where the lens is not known there.
double largest_shift(const Lens& lens, const Camera& camera);

}  // namespace gestalt
