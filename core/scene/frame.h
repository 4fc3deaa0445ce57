// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <string>

#include "gestalt/core/base/deadline.h"
#include "gestalt/core/base/export.h"
#include "gestalt/core/scene/depth_noise.h"

namespace gestalt {

/// Pinhole intrinsics in pixels. Camera frame: x right, y down, z forward.
struct Camera {
  int width = 0;
  int height = 0;
  double fx = 0;
  double fy = 0;
  double cx = 0;
  double cy = 0;
};

/// Pixels of this camera in the solid angle of one pixel at a focal length of 525 px, that of a Kinect at 640x480.
/// Pixel counts in parameters are those of such a camera: multiply with this.
inline double pixel_density(const Camera& camera) { return camera.fx * camera.fy / (525.0 * 525.0); }

/// One organized RGB-D frame, immutable once made by make_frame(). All images have the camera's size.
struct Frame {
  std::string name;
  cv::Mat colour;              ///< CV_8UC3, blue green red; empty when the input has no colour
  cv::Mat_<float> depth;       ///< metres along the optical axis; 0 = no measurement, never NaN or negative
  cv::Mat_<cv::Vec3f> points;  ///< metres, camera frame; (0, 0, 0) where depth is 0
  Camera camera;
  DepthNoise noise;     ///< of depth; the config's sensor, set by the pipeline
  Deadline deadline{};  ///< set by the pipeline; a component whose loops may be long asks it to require() more time

  int width() const { return depth.cols; }
  int height() const { return depth.rows; }
  bool has_colour() const { return !colour.empty(); }
  bool valid(int pixel) const { return depth.ptr<float>()[pixel] > 0; }

  /// Point of a pixel given by its row-major index v * width + u.
  Eigen::Vector3f point(int pixel) const {
    const cv::Vec3f& p = points.ptr<cv::Vec3f>()[pixel];
    return {p[0], p[1], p[2]};
  }
};

/// Checks the images and the camera against each other and computes the points.
/// Depth values outside of [1 mm, 1 km], NaN among them, become 0. colour may be empty (then colour relations cannot be
/// used), else CV_8UC3. Throws InputError when sizes differ, the image is empty, a focal length is not in
/// [0.001, 1e6] times the image's size, the principal point lies outside the image, or no pixel has depth.
GESTALT_EXPORT Frame make_frame(std::string name, cv::Mat colour, cv::Mat_<float> depth, const Camera& camera);

}  // namespace gestalt
