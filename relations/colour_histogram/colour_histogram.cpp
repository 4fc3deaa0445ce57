// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "colour_histogram.h"

#include <array>

#include "gestalt/core/scene/histogram.h"

namespace gestalt {

namespace {

class ColourHistogramMeasure final : public Measure {
 public:
  ColourHistogramMeasure(const cv::Mat& yuv, const SurfaceSet& surfaces, int bins)
      : size_(std::size_t(bins * bins * bins)), roots_(surfaces.surfaces.size() * size_) {
    std::array<int, 256> bin;
    for (int level = 0; level < 256; ++level) bin[std::size_t(level)] = level * bins / 256;
    const cv::Vec3b* colours = yuv.ptr<cv::Vec3b>();
    for (std::size_t i = 0; i < surfaces.surfaces.size(); ++i) {
      const std::span<float> counts = histogram(int(i));
      for (const int pixel : surfaces.surfaces[i].pixels) {
        const cv::Vec3b& c = colours[pixel];
        counts[std::size_t((bin[c[0]] * bins + bin[c[1]]) * bins + bin[c[2]])] += 1;
      }
      take_root_shares(counts);
    }
  }

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    values[0] = bhattacharyya(histogram(pair.a), histogram(pair.b));
  }

 private:
  std::span<float> histogram(int surface) { return {&roots_[std::size_t(surface) * size_], size_}; }
  std::span<const float> histogram(int surface) const { return {&roots_[std::size_t(surface) * size_], size_}; }

  std::size_t size_;
  std::vector<float> roots_;  // root shares, surface after surface
};

}  // namespace

const Parameters<ColourHistogram::Params>& ColourHistogram::parameters() {
  static const auto p = Parameters<Params>().integer("bins", &Params::bins, 1, 32, "",
                                                     "bins of each of the three channels, which divide 0..255 evenly");
  return p;
}

const std::vector<RelationValue>& ColourHistogram::values() const {
  static const std::vector<RelationValue> values{
      {"r_co", 0, 1, "Bhattacharyya coefficient of the YUV histograms, 1 for equal ones"}};
  return values;
}

std::unique_ptr<Measure> ColourHistogram::bind(const Scene& scene) const {
  return std::make_unique<ColourHistogramMeasure>(scene.yuv(), scene.surfaces(), params_.bins);
}

}  // namespace gestalt
