// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/frame.h"

#include <sstream>

#include "gestalt/core/base/error.h"

namespace gestalt {

namespace {

// No sensor measures what is nearer or farther, and of what lies beyond, squares and products are no longer numbers.
constexpr float nearest = 0.001F, farthest = 1000.F;
constexpr double shortest_focal_length = 0.001, longest_focal_length = 1e6;  // of the image's size

void check_camera(const std::string& name, const Camera& c, cv::Size size) {
  const auto fail = [&](const std::string& what) {
    std::ostringstream message;
    message << name << ": camera: " << what;
    throw InputError(message.str());
  };
  const auto sound = [](double f, int pixels) {
    return f >= shortest_focal_length * pixels && f <= longest_focal_length * pixels;
  };
  if (!sound(c.fx, size.width) || !sound(c.fy, size.height))
    fail("focal lengths fx = " + std::to_string(c.fx) + ", fy = " + std::to_string(c.fy) +
         " must be positive pixel numbers, from a thousandth to a million times the image's size; correct camera.yaml "
         "or give --camera");
  if (c.width != size.width || c.height != size.height)
    fail("is for " + std::to_string(c.width) + "x" + std::to_string(c.height) + " images, but the depth image is " +
         std::to_string(size.width) + "x" + std::to_string(size.height) + "; give the camera file of this sensor mode");
  if (!(c.cx >= 0 && c.cx <= size.width && c.cy >= 0 && c.cy <= size.height))
    fail("principal point cx = " + std::to_string(c.cx) + ", cy = " + std::to_string(c.cy) +
         " lies outside the image; correct camera.yaml or give --camera");
}

}  // namespace

Frame make_frame(std::string name, cv::Mat colour, cv::Mat_<float> depth, const Camera& camera) {
  if (depth.empty()) throw InputError(name + ": the depth image is empty");
  if (!colour.empty() && colour.size() != depth.size())
    throw InputError(name + ": colour is " + std::to_string(colour.cols) + "x" + std::to_string(colour.rows) +
                     ", depth is " + std::to_string(depth.cols) + "x" + std::to_string(depth.rows) +
                     "; register the two images to the same size");
  if (!colour.empty() && colour.type() != CV_8UC3) throw InputError(name + ": colour must have 3 channels of 8 bits");
  check_camera(name, camera, depth.size());

  Frame frame{std::move(name), std::move(colour), depth.clone(), cv::Mat_<cv::Vec3f>(depth.size()), camera, {}, {}};
  const auto inverse_fx = float(1 / camera.fx), inverse_fy = float(1 / camera.fy);
  const auto cx = float(camera.cx), cy = float(camera.cy);
  bool any = false;
  for (int v = 0; v < frame.height(); ++v) {
    float* z = frame.depth[v];
    cv::Vec3f* p = frame.points[v];
    for (int u = 0; u < frame.width(); ++u) {
      if (!(z[u] >= nearest && z[u] <= farthest)) z[u] = 0;
      any = any || z[u] > 0;
      p[u] = {(float(u) - cx) * inverse_fx * z[u], (float(v) - cy) * inverse_fy * z[u], z[u]};
    }
  }
  if (!any) throw InputError(frame.name + ": no pixel of the depth image has a measurement");
  return frame;
}

}  // namespace gestalt
