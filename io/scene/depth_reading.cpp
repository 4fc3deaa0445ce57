// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/depth_reading.h"

#include <algorithm>
#include <cmath>

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/depth_plausibility.h"
#include "scene_camera.h"

namespace gestalt {

namespace {

/// Distances from the camera's centre, divided by the lengths of the pixels' rays.
void make_axial(cv::Mat_<float>& depth, const Camera& camera) {
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u) {
      const double x = (u - camera.cx) / camera.fx, y = (v - camera.cy) / camera.fy;
      depth(v, u) = float(depth(v, u) / std::sqrt(x * x + y * y + 1));
    }
}

/// 65535 stands for "no measurement" with many.
void drop_largest(DepthReading& depth) {
  const auto none = float(65535 * depth.unit.metres);
  for (float& d : depth.metres)
    if (d == none) d = 0;
}

}  // namespace

DepthReading depth_reading(const cv::Mat_<std::uint16_t>& raw, const ReadOptions& options,
                           const std::optional<CameraFile>& camera) {
  const DepthUnit unit = unit_of_whole_numbers(options, camera);
  if (options.depth_kind != DepthKind::rotated)
    return {depth_in_metres(raw, unit.metres), unit, true, options.depth_kind};
  cv::Mat_<std::uint16_t> turned(raw.size());
  std::transform(raw.begin(), raw.end(), turned.begin(),
                 [](std::uint16_t d) { return std::uint16_t(d >> 3 | d << 13); });
  return {depth_in_metres(turned, unit.metres), unit, true, options.depth_kind};
}

DepthReading float_reading(const cv::Mat_<float>& raw, const ReadOptions& options) {
  DepthReading reading{cv::Mat_<float>(raw.size()), unit_of_floats(options), false, options.depth_kind};
  std::transform(raw.begin(), raw.end(), reading.metres.begin(),
                 [&](float d) { return float(double(d) * reading.unit.metres); });
  return reading;
}

void set_frame(Input& input, const std::string& name, const cv::Mat& colour, DepthReading depth, const Camera& camera) {
  if (depth.kind == DepthKind::rotated && !depth.whole_numbers)
    throw InputError(name +
                     ": its depth is not 16-bit whole numbers, whose bits could be rotated; leave out "
                     "--depth-kind rotated");
  if (depth.whole_numbers) drop_largest(depth);
  question_pixels(name, camera, input.warnings);
  question_depth(name, depth, camera, input.warnings);
  if (depth.kind == DepthKind::radial) make_axial(depth.metres, camera);
  input.depth_unit = text(depth.unit);
  input.frame = make_frame(name, colour, depth.metres, camera);
}

}  // namespace gestalt
