// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "hostile_scene.h"

#include <cmath>
#include <limits>
#include <map>

namespace gestalt::properties {

namespace {

constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();

const std::vector<float> hostile_depths{
    0.F,    -1.F,   nan,     inf,     -inf, std::numeric_limits<float>::denorm_min(),
    1e-40F, 1e-30F, 0.0009F, 0.001F,  1.F,  999.9F,
    1000.F, 1001.F, 1e30F,   3.4e38F, -0.F};

cv::Rect any_part(Chance& chance, cv::Size size) {
  const int left = chance.whole(0, size.width - 1), top = chance.whole(0, size.height - 1);
  return {left, top, chance.whole(1, size.width - left), chance.whole(1, size.height - top)};
}

cv::Mat_<float> any_depth(Chance& chance, cv::Size size) {
  cv::Mat_<float> depth(size, chance.one_in(3) ? chance.one_of(hostile_depths) : float(chance.real(0.3, 5)));
  for (int plane = chance.whole(0, 5); plane > 0; --plane) {
    const cv::Rect part = any_part(chance, size);
    const double base = chance.one_in(8) ? chance.real(0.001, 0.01) : chance.real(0.2, 900);
    const double steep = chance.one_in(3) ? 10 : 0.1;  // the former is almost edge-on
    const double across = chance.real(-steep, steep), down = chance.real(-steep, steep);
    const double bend = chance.one_in(3) ? chance.real(-0.01, 0.01) : 0;
    const double noise = chance.one_in(4) ? 0.05 : 0;
    for (int v = 0; v < part.height; ++v)
      for (int u = 0; u < part.width; ++u)
        depth(part.y + v, part.x + u) =
            float(base + across * u + down * v + bend * u * u + (noise > 0 ? chance.real(-noise, noise) : 0));
  }
  for (int pixel = chance.whole(0, 12); pixel > 0; --pixel)
    depth(chance.whole(0, size.height - 1), chance.whole(0, size.width - 1)) = chance.one_of(hostile_depths);
  depth(chance.whole(0, size.height - 1), chance.whole(0, size.width - 1)) = 1;
  return depth;
}

cv::Mat any_colour(Chance& chance, cv::Size size) {
  cv::Mat_<cv::Vec3b> colour(size, cv::Vec3b(0, 0, 0));
  const int kind = chance.whole(0, 3);
  if (kind == 0) colour.setTo(cv::Scalar::all(chance.one_in(2) ? 255 : 0));
  if (kind == 1) colour.setTo(cv::Scalar(chance.whole(0, 255), chance.whole(0, 255), chance.whole(0, 255)));
  if (kind == 2)
    for (int v = 0; v < size.height; v += 2) colour.row(v).setTo(cv::Scalar(255, 255, 255));
  if (kind == 3)
    for (cv::Vec3b& pixel : colour)
      pixel = {std::uint8_t(chance.whole(0, 255)), std::uint8_t(chance.whole(0, 255)),
               std::uint8_t(chance.whole(0, 255))};
  return colour;
}

/// Any number for a pixel; equal numbers make a patch.
std::function<int(int u, int v)> any_partition(Chance& chance) {
  const int size = chance.whole(2, 9);
  switch (chance.whole(0, 6)) {
    case 0:
      return [](int, int) { return 1; };
    case 1:
      return [](int u, int v) { return 1 + v * 64 + u; };
    case 2:
      return [](int, int v) { return 1 + v; };
    case 3:
      return [](int u, int) { return 1 + u; };
    case 4:
      return [](int u, int v) { return 1 + (u + v) % 2; };
    case 5:
      return [size](int u, int v) { return 1 + v / size * 64 + u / size; };
    default:
      return [size, &chance](int, int) { return chance.whole(0, size); };
  }
}

}  // namespace

Frame hostile_frame(Chance& chance) {
  const cv::Size size(chance.whole(1, 28), chance.whole(1, 22));
  const double focal = chance.one_in(2) ? chance.one_of(std::vector<double>{0.05, 1, 30, 525, 5000})
                                        : std::pow(10, chance.real(-1.5, 5.5));
  const Camera camera{size.width,
                      size.height,
                      focal,
                      chance.one_in(4) ? 2 * focal : focal,
                      chance.one_in(4) ? 0 : size.width / 2.0,
                      chance.one_in(4) ? size.height : size.height / 2.0};
  return make_frame("hostile", any_colour(chance, size), any_depth(chance, size), camera);
}

PatchMap hostile_patches(Chance& chance, const Frame& frame) {
  PatchMap patches{cv::Mat_<int>(frame.depth.size(), 0), cv::Mat_<cv::Vec3f>(frame.depth.size(), cv::Vec3f(0, 0, 0)),
                   0};
  const auto partition = any_partition(chance);
  std::map<int, int> numbers;
  for (int v = 0; v < frame.height(); ++v)
    for (int u = 0; u < frame.width(); ++u) {
      if (!(frame.depth(v, u) > 0)) continue;
      if (const int part = partition(u, v); part > 0)
        patches.labels(v, u) = numbers.try_emplace(part, int(numbers.size()) + 1).first->second;
      if (chance.one_in(5)) continue;
      cv::Vec3d normal(chance.real(-1, 1), chance.real(-1, 1), -chance.real(0.01, 1));
      normal /= cv::norm(normal);
      if (normal.dot(cv::Vec3d(frame.points(v, u))) < 0) patches.normals(v, u) = cv::Vec3f(normal);
    }
  patches.count = int(numbers.size());
  return patches;
}

}  // namespace gestalt::properties
