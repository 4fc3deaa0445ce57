// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "virtual_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "camera_fit.h"
#include "most_pixels.h"

namespace gestalt {

namespace {

constexpr std::size_t fewest_points = 1000;
constexpr double filled = 0.85;       // fewer neighbours are missing at the edges of what is seen
constexpr double mostly_empty = 0.5;  // of a camera that somebody gave: it may be right, and the scene full of holes
constexpr double step = 0.85;         // from one size to the next smaller one

std::size_t visible_points(const PointCloud& cloud) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) count += cloud.visible(i);
  return count;
}

cv::Size size_at(const Camera& camera, double factor) {
  const auto side = [&](int pixels) { return std::max(1, int(std::lround(pixels * factor))); };
  return {side(camera.width), side(camera.height)};
}

/// The largest of the camera's sizes whose pixels the points fill; nothing when that has hardly a pixel.
std::optional<Camera> largest_filled(const PointCloud& cloud, const Camera& camera) {
  constexpr int fewest_pixels = 32;  // of a side
  for (double factor = 1;; factor *= step) {
    const cv::Size size = size_at(camera, factor);
    if (size.width < fewest_pixels || size.height < fewest_pixels) return std::nullopt;
    const Camera smaller = scaled(camera, size);
    if (filled_share(cloud, smaller) >= filled) return smaller;
  }
}

}  // namespace

double filled_share(const PointCloud& cloud, const Camera& camera) {
  const int width = camera.width, height = camera.height;
  std::vector<bool> occupied(std::size_t(width) * std::size_t(height));
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (cloud.visible(i))
      if (const int pixel = pixel_of(cloud.points[i], camera); pixel >= 0) occupied[std::size_t(pixel)] = true;
  const std::array<int, 8> neighbours{-width - 1, -width, -width + 1, -1, 1, width - 1, width, width + 1};
  std::size_t pixels = 0, beside = 0;
  for (int v = 1; v < height - 1; ++v)
    for (int u = 1; u < width - 1; ++u) {
      const int pixel = v * width + u;
      if (!occupied[std::size_t(pixel)]) continue;
      ++pixels;
      for (const int neighbour : neighbours) beside += occupied[std::size_t(pixel + neighbour)];
    }
  return pixels == 0 ? 0 : double(beside) / double(neighbours.size() * pixels);
}

Camera scaled(const Camera& camera, cv::Size size) {
  const double x = double(size.width) / camera.width, y = double(size.height) / camera.height;
  // (0, 0) is the centre of the first pixel, whose corner stays where it is.
  return {
      size.width, size.height, camera.fx * x, camera.fy * y, (camera.cx + 0.5) * x - 0.5, (camera.cy + 0.5) * y - 0.5};
}

std::optional<Camera> virtual_camera(const PointCloud& cloud) {
  constexpr double pixels_a_point = 64;  // to begin with: what is seen may fill little of the rectangle around it
  const std::size_t points = visible_points(cloud);
  if (points < fewest_points) return std::nullopt;
  // The outermost hundredth of the points does not tell the size of the image.
  std::vector<double> x, y;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (cloud.visible(i)) {
      const cv::Vec3f& p = cloud.points[i];
      x.push_back(double(p[0]) / p[2]), y.push_back(double(p[1]) / p[2]);
    }
  const auto quantile = [](std::vector<double>& values, double share) {
    const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  // The image contains the optical axis, as images of cameras do.
  const auto range = [&](std::vector<double>& values) {
    const double low = quantile(values, 0.001), high = quantile(values, 0.999), margin = 0.01 * (high - low);
    return std::array{std::min(low - margin, 0.0), std::max(high + margin, 0.0)};
  };
  const auto [left, right] = range(x);
  const auto [top, bottom] = range(y);
  const double area = (right - left) * (bottom - top);
  if (!(area > 0)) return std::nullopt;
  const double pixels = std::min(pixels_a_point * double(points), double(most_pixels) / 2);
  const double focal_length = std::sqrt(pixels / area);
  const double width = std::ceil((right - left) * focal_length) + 1,
               height = std::ceil((bottom - top) * focal_length) + 1;
  if (!(width * height <= double(most_pixels))) return std::nullopt;
  return largest_filled(
      cloud, {int(width), int(height), focal_length, focal_length, -left * focal_length, -top * focal_length});
}

double overlapping_share(const PointCloud& cloud, const Camera& camera) {
  constexpr double pixels_a_side = 4;
  constexpr float far_behind = 1.15F;
  const Camera coarse = scaled(camera, size_at(camera, 1 / pixels_a_side));
  const std::size_t places = std::size_t(coarse.width) * std::size_t(coarse.height);
  std::vector<float> nearest(places, 0), farthest(places, 0);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const int place = cloud.visible(i) ? pixel_of(cloud.points[i], coarse) : -1;
    if (place < 0) continue;
    const float z = cloud.points[i][2];
    float& near = nearest[std::size_t(place)];
    near = near > 0 ? std::min(near, z) : z;
    farthest[std::size_t(place)] = std::max(farthest[std::size_t(place)], z);
  }
  std::size_t seen = 0, overlapping = 0;
  for (std::size_t i = 0; i < places; ++i) {
    seen += nearest[i] > 0;
    overlapping += farthest[i] > far_behind * nearest[i];
  }
  return seen == 0 ? 0 : double(overlapping) / double(seen);
}

Camera filled_camera(const PointCloud& cloud, const Camera& camera) {
  std::size_t seen = 0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    seen += cloud.visible(i) && pixel_of(cloud.points[i], camera) >= 0;
  if (seen < fewest_points || filled_share(cloud, camera) >= mostly_empty) return camera;
  return largest_filled(cloud, camera).value_or(camera);
}

}  // namespace gestalt
