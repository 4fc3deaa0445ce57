// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "facets.h"

#include "gestalt/synthesis/synthesis.h"

namespace gestalt::bench {

Frame facets(int columns, int rows) {
  constexpr double distance = 0.8, slope = 1;
  const Camera camera = kinect_camera();
  cv::Mat_<float> depth(camera.height, camera.width);
  cv::Mat colour(depth.size(), CV_8UC3);
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const int column = u * columns / camera.width, row = v * rows / camera.height;
      const double centre_x = ((column + 0.5) * camera.width / columns - camera.cx) / camera.fx;
      const double centre_y = ((row + 0.5) * camera.height / rows - camera.cy) / camera.fy;
      const double slope_x = column % 2 ? slope : -slope, slope_y = row % 2 ? slope : -slope;
      // The plane z = distance + slope_x (x - x_0) + slope_y (y - y_0) along the pixel's ray.
      const double x = (u - camera.cx) / camera.fx, y = (v - camera.cy) / camera.fy;
      depth(v, u) = float(distance * (1 - slope_x * centre_x - slope_y * centre_y) / (1 - slope_x * x - slope_y * y));
      colour.at<cv::Vec3b>(v, u) =
          cv::Vec3b(uchar(50 + 37 * column % 150), uchar(50 + 53 * row % 150), uchar(50 + 71 * (column + row) % 150));
    }
  return make_frame("facets_" + std::to_string(columns * rows), colour, depth, camera);
}

}  // namespace gestalt::bench
