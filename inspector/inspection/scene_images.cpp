// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scene_images.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "gestalt/core/base/output_file.h"
#include "gestalt/core/pipeline/learning_set.h"
#include "gestalt/io/scene/png_codec.h"

namespace gestalt {

using nlohmann::json;

namespace {

constexpr double most_pixels = 1e6;

std::string base64(const std::string& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? std::uint32_t(std::uint8_t(bytes[i + k])) : 0;
    };
    const std::uint32_t three = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63];
  }
  return text;
}

/// Every step-th pixel, step the same in both directions.
cv::Mat thinned(const cv::Mat& image, int step) {
  if (step == 1) return image;
  cv::Mat thin((image.rows + step - 1) / step, (image.cols + step - 1) / step, image.type());
  for (int v = 0; v < thin.rows; ++v)
    for (int u = 0; u < thin.cols; ++u) std::copy_n(image.ptr(v * step, u * step), image.elemSize(), thin.ptr(v, u));
  return thin;
}

std::string uri(const cv::Mat& image) { return "data:image/png;base64," + base64(encode_png(image)); }

/// A browser reads 16 bits of a PNG as 8: so they are two channels.
std::string uri_of_numbers(const cv::Mat_<int>& numbers) {
  cv::Mat_<cv::Vec3b> image(numbers.size());
  for (int v = 0; v < numbers.rows; ++v)
    for (int u = 0; u < numbers.cols; ++u) {
      const int number = numbers(v, u);
      image(v, u) = {0, std::uint8_t(number & 255), std::uint8_t(number >> 8 & 255)};
    }
  return uri(image);
}

/// The smallest of 0.1 mm, 0.2 mm, 0.5 mm, 1 mm, ... in which 16 bits hold the farthest depth.
double depth_unit(const cv::Mat_<float>& depth) {
  double farthest = 0;
  cv::minMaxLoc(depth, nullptr, &farthest);
  for (double decade = 1e-4;; decade *= 10)
    for (const int factor : {1, 2, 5})
      if (farthest <= 65535 * decade * factor) return decade * factor;
}

cv::Mat_<int> in_units(const cv::Mat_<float>& depth, double unit) {
  cv::Mat_<int> numbers(depth.size());
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u) numbers(v, u) = int(std::lround(depth(v, u) / unit));
  return numbers;
}

cv::Mat_<int> objects_of(const cv::Mat_<std::uint16_t>& truth) {
  cv::Mat_<int> objects(truth.size());
  for (int v = 0; v < truth.rows; ++v)
    for (int u = 0; u < truth.cols; ++u) objects(v, u) = object_of_label(truth(v, u));
  return objects;
}

cv::Mat normals_of(const Frame& frame, const SurfaceSet& surfaces, int step) {
  cv::Mat_<cv::Vec3b> image((frame.height() + step - 1) / step, (frame.width() + step - 1) / step, cv::Vec3b());
  const auto byte = [](float x) { return std::uint8_t(std::lround(127.5f * (x + 1))); };
  tbb::parallel_for(std::size_t{0}, surfaces.surfaces.size(), [&](std::size_t i) {
    for (const int pixel : surfaces.surfaces[i].pixels) {
      const int u = pixel % frame.width(), v = pixel / frame.width();
      if (u % step != 0 || v % step != 0) continue;
      const Eigen::Vector3f n = surfaces.surfaces[i].model->foot(frame.point(pixel)).normal;
      image(v / step, u / step) = {byte(-n.z()), byte(-n.y()), byte(n.x())};  // blue first
    }
  });
  return image;
}

/// 1 at an edge of the colour image, as the relation texture_quantity counts them by default; 2 where a patch was cut
/// along one; else 0. A pixel of the thinned image has the largest of those that it stands for.
cv::Mat_<int> image_edges(const cv::Mat& colour, const PatchMap& patches, int step) {
  cv::Mat grey, edges;
  cv::cvtColor(colour, grey, cv::COLOR_BGR2GRAY);
  cv::blur(grey, grey, {3, 3});
  cv::Canny(grey, edges, 5, 140);
  cv::Mat_<int> numbers((colour.rows + step - 1) / step, (colour.cols + step - 1) / step, 0);
  const auto raise = [&](int v, int u, int number) {
    int& there = numbers(v / step, u / step);
    there = std::max(there, number);
  };
  const auto is_cut = [&](int a, int b) {
    if (a == b || a == 0 || b == 0 || patches.cut_from.empty()) return false;
    return patches.cut_from[std::size_t(a - 1)] == patches.cut_from[std::size_t(b - 1)];
  };
  const cv::Mat_<int>& labels = patches.labels;
  for (int v = 0; v < colour.rows; ++v)
    for (int u = 0; u < colour.cols; ++u) {
      if (edges.at<std::uint8_t>(v, u)) raise(v, u, 1);
      if ((u + 1 < colour.cols && is_cut(labels(v, u), labels(v, u + 1))) ||
          (v + 1 < colour.rows && is_cut(labels(v, u), labels(v + 1, u))))
        raise(v, u, 2);
    }
  return numbers;
}

}  // namespace

json scene_images(const Input& input, const Percept& percept) {
  const Frame& frame = input.frame;
  const int step = int(std::ceil(std::sqrt(double(frame.depth.total()) / most_pixels)));
  const double unit = depth_unit(frame.depth);
  const auto numbers = [&](const cv::Mat_<int>& image) { return uri_of_numbers(thinned(image, step)); };
  return {
      {"step", step},
      {"colour", frame.has_colour() ? json(uri(thinned(frame.colour, step))) : json()},
      {"depth", numbers(in_units(frame.depth, unit))},
      {"depth_unit", unit},
      {"patches", numbers(percept.surfaces().labels)},
      {"normals", uri(normals_of(frame, percept.surfaces(), step))},
      {"edges", frame.has_colour() ? json(uri_of_numbers(image_edges(frame.colour, percept.patches(), step))) : json()},
      {"truth", input.ground_truth.empty() ? json() : json(numbers(objects_of(input.ground_truth)))}};
}

}  // namespace gestalt
