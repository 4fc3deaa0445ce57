// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "texture_quantity.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace gestalt {

namespace {

struct Edges final : Observation {
  cv::Mat image;  // CV_8UC1, 0 where there is none
};

class TextureQuantityMeasure final : public Measure {
 public:
  TextureQuantityMeasure(const cv::Mat& edges, const SurfaceSet& surfaces) {
    const uchar* edge = edges.ptr();
    for (const Surface& surface : surfaces.surfaces) {
      const auto count =
          std::count_if(surface.pixels.begin(), surface.pixels.end(), [&](int p) { return edge[p] != 0; });
      quantities_.push_back(double(count) / double(surface.pixels.size()));
    }
  }

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    values[0] = std::abs(quantities_[std::size_t(pair.a)] - quantities_[std::size_t(pair.b)]);
  }

 private:
  std::vector<double> quantities_;  // share of edge pixels of each surface
};

}  // namespace

const Parameters<TextureQuantity::Params>& TextureQuantity::parameters() {
  static const auto p =
      Parameters<Params>()
          .integer("blur", &Params::blur, 1, 31, "px", "side of the box that smoothes the grey image, 1 for none")
          .real("low_threshold", &Params::low_threshold, 0, 2040, "grey levels",
                "gradient (Sobel, |dx| + |dy|) above which an edge goes on")
          .real("high_threshold", &Params::high_threshold, 0, 2040, "grey levels",
                "gradient (Sobel, |dx| + |dy|) above which an edge begins");
  return p;
}

const std::vector<RelationValue>& TextureQuantity::values() const {
  static const std::vector<RelationValue> values{
      {"r_tr", 0, 1, "difference of the shares of Canny edge pixels, 0 for equally textured patches"}};
  return values;
}

std::unique_ptr<Observation> TextureQuantity::observe(const Images& images) const {
  auto edges = std::make_unique<Edges>();
  cv::Mat smooth;
  cv::blur(images.grey(), smooth, cv::Size(params_.blur, params_.blur));
  cv::Canny(smooth, edges->image, params_.low_threshold, params_.high_threshold);
  return edges;
}

std::unique_ptr<Measure> TextureQuantity::bind(const Scene& scene) const {
  return std::make_unique<TextureQuantityMeasure>(scene.observed<Edges>(*this).image, scene.surfaces());
}

}  // namespace gestalt
