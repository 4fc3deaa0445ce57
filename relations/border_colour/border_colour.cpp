// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "border_colour.h"

#include <cmath>
#include <numbers>

namespace gestalt {

namespace {

constexpr double uv_diagonal = 255 * std::numbers::sqrt2;

class BorderColourMeasure final : public Measure {
 public:
  explicit BorderColourMeasure(const cv::Mat& yuv) : yuv_(yuv) {}

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    values[0] = 0;
    if (!pair.border) return;
    const auto& border = pair.border->border_3d.empty() ? pair.border->border_2d : pair.border->border_3d;
    if (border.empty()) return;
    double sum = 0;
    for (const PixelPair& pixels : border) {
      const cv::Vec3b& a = yuv_.ptr<cv::Vec3b>()[pixels.a];
      const cv::Vec3b& b = yuv_.ptr<cv::Vec3b>()[pixels.b];
      sum += std::hypot(a[1] - b[1], a[2] - b[2]);
    }
    values[0] = 1 - sum / (double(border.size()) * uv_diagonal);
  }

 private:
  const cv::Mat& yuv_;
};

}  // namespace

const Parameters<BorderColour::Params>& BorderColour::parameters() {
  static const Parameters<Params> none;
  return none;
}

const std::vector<RelationValue>& BorderColour::values() const {
  static const std::vector<RelationValue> values{
      {"r_co3", 0, 1, "mean colour similarity of the border's pixel pairs, 1 for equal chroma, 0 without a border"}};
  return values;
}

std::unique_ptr<Measure> BorderColour::bind(const Scene& scene) const {
  return std::make_unique<BorderColourMeasure>(scene.yuv());
}

}  // namespace gestalt
