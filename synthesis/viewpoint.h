// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

#include "gestalt/core/scene/frame.h"

namespace gestalt::synthesis {

/// A camera and where it stands.
struct Viewpoint {
  Camera camera;
  Eigen::Isometry3d pose;  ///< camera frame to world
};

/// A quick look at the scene while it is laid out: things as clouds of points, in an image of about 160 columns.
class Preview {
 public:
  explicit Preview(const Viewpoint& viewpoint);

  /// The share of the points (world, metres) that falls into the image.
  double share_inside(std::span<const Eigen::Vector3f> points) const;

  /// Draws the next thing; its number is the count of those before. Takes it back, and is false, when it or any before
  /// is then seen in fewer than smallest pixels of the camera.
  bool add(std::span<const Eigen::Vector3f> points, double smallest);

  /// Draws background before things.
  void hide_behind(std::span<const Eigen::Vector3f> points);

  /// Sizes of the separate visible parts of a thing in pixels of the camera, largest first.
  std::vector<double> visible_parts(int thing) const;

 private:
  /// Where the points are nearer than what is drawn. thing: its number, or -1 for what is none.
  void draw(std::span<const Eigen::Vector3f> points, int thing);
  cv::Point pixel_of(const Eigen::Vector3f& in_camera) const;

  Camera camera_;
  double scale_;  ///< of the preview to the camera
  Eigen::Isometry3f from_world_;
  cv::Mat_<float> depth_;
  cv::Mat_<int> thing_;
  int things_ = 0;
};

}  // namespace gestalt::synthesis
