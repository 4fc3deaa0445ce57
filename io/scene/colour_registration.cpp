// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "colour_registration.h"

#include <opencv2/imgproc.hpp>

namespace gestalt {

cv::Mat registered_colour(const cv::Mat& colour, const Camera& colour_camera, const cv::Affine3d& colour_from_depth,
                          const cv::Mat_<float>& depth, const Camera& depth_camera) {
  cv::Mat_<cv::Vec2f> seen_in(depth.size());
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u) {
      const double z = depth(v, u);
      seen_in(v, u) = {-2, -2};  // outside
      if (!(z > 0)) continue;
      const cv::Vec3d p = colour_from_depth * cv::Vec3d((u - depth_camera.cx) * z / depth_camera.fx,
                                                        (v - depth_camera.cy) * z / depth_camera.fy, z);
      if (p[2] > 0)
        seen_in(v, u) = {float(colour_camera.fx * p[0] / p[2] + colour_camera.cx),
                         float(colour_camera.fy * p[1] / p[2] + colour_camera.cy)};
    }
  cv::Mat result;
  cv::remap(colour, result, seen_in, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT);
  return result;
}

}  // namespace gestalt
