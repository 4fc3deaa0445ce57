// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fourier.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "gestalt/core/scene/histogram.h"

namespace gestalt {

namespace {

constexpr std::size_t coefficients = 5;

/// For each coefficient, the bin of every pixel.
struct BinImages final : Observation {
  std::array<cv::Mat_<uchar>, coefficients> of;
};

/// Bins of |X_k| / 8 are this many to a unit of |X_k|.
std::array<float, coefficients> bins_per_unit(const Fourier::Params& params) {
  std::array<float, coefficients> scale;
  for (std::size_t k = 0; k < coefficients; ++k) {
    const double divisor = k == 0 ? 1 : params.divisor_offset + params.divisor_slope * double(k);
    scale[k] = float(divisor / params.bin_width / 8);
  }
  return scale;
}

/// The eight neighbours' transform in two steps of the fast Fourier transform, for pixels 1..width of three padded
/// rows.
void transform_row(const uchar* above, const uchar* row, const uchar* below, int width,
                   std::array<float, coefficients> scale, int bins, std::array<uchar*, coefficients> bin) {
  constexpr float root = float(std::numbers::sqrt2 / 2);
  const float last = float(bins - 1);
  const auto bin_of = [last](float position) { return uchar(int(std::min(position, last))); };
  const auto magnitude = [](float re, float im) { return std::sqrt(re * re + im * im); };
  for (int u = 0; u < width; ++u) {
    // Ring from the right neighbour on; each with its opposite one.
    const int east = row[u + 2], south_east = below[u + 2], south = below[u + 1], south_west = below[u];
    const int west = row[u], north_west = above[u], north = above[u + 1], north_east = above[u + 2];
    const int even0 = east + west, even1 = south_east + north_west, even2 = south + north,
              even3 = south_west + north_east;
    const float odd0 = float(east - west), odd2 = float(south - north);
    const int odd1 = south_east - north_west, odd3 = south_west - north_east;
    const float re = root * float(odd1 - odd3), im = root * float(odd1 + odd3);
    bin[0][u] = bin_of(scale[0] * float(even0 + even1 + even2 + even3));
    bin[1][u] = bin_of(scale[1] * magnitude(odd0 + re, odd2 + im));
    bin[2][u] = bin_of(scale[2] * magnitude(float(even0 - even2), float(even1 - even3)));
    bin[3][u] = bin_of(scale[3] * magnitude(odd0 - re, odd2 - im));
    bin[4][u] = bin_of(scale[4] * std::abs(float(even0 - even1 + even2 - even3)));
  }
}

std::unique_ptr<BinImages> transform(const cv::Mat& grey, const Fourier::Params& params) {
  auto images = std::make_unique<BinImages>();
  auto& of = images->of;
  for (auto& image : of) image.create(grey.size());
  cv::Mat padded;
  cv::copyMakeBorder(grey, padded, 1, 1, 1, 1, cv::BORDER_REPLICATE);
  const auto scale = bins_per_unit(params);
  tbb::parallel_for(tbb::blocked_range<int>(0, grey.rows, 32), [&](const tbb::blocked_range<int>& rows) {
    for (int v = rows.begin(); v < rows.end(); ++v)
      transform_row(padded.ptr(v), padded.ptr(v + 1), padded.ptr(v + 2), grey.cols, scale, params.bins,
                    {of[0][v], of[1][v], of[2][v], of[3][v], of[4][v]});
  });
  return images;
}

class FourierMeasure final : public Measure {
 public:
  FourierMeasure(const BinImages& images, const SurfaceSet& surfaces, int bins)
      : bins_(std::size_t(bins)), roots_(surfaces.surfaces.size() * coefficients * bins_) {
    const std::array<const uchar*, coefficients> bin{images.of[0][0], images.of[1][0], images.of[2][0], images.of[3][0],
                                                     images.of[4][0]};
    tbb::parallel_for(std::size_t{0}, surfaces.surfaces.size(), [&](std::size_t i) {
      float* counts = &roots_[i * coefficients * bins_];
      for (const int pixel : surfaces.surfaces[i].pixels)
        for (std::size_t k = 0; k < coefficients; ++k) counts[k * bins_ + bin[k][pixel]] += 1;
      for (std::size_t k = 0; k < coefficients; ++k) take_root_shares({counts + k * bins_, bins_});
    });
  }

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    double sum = 0;
    for (std::size_t k = 0; k < coefficients; ++k) sum += bhattacharyya(histogram(pair.a, k), histogram(pair.b, k));
    values[0] = sum / double(coefficients);
  }

 private:
  std::span<const float> histogram(int surface, std::size_t k) const {
    return {&roots_[(std::size_t(surface) * coefficients + k) * bins_], bins_};
  }

  std::size_t bins_;
  std::vector<float> roots_;  // root shares of every surface's five histograms
};

}  // namespace

const Parameters<Fourier::Params>& Fourier::parameters() {
  static const auto p =
      Parameters<Params>()
          .integer("bins", &Params::bins, 1, 256, "", "bins of each coefficient's histogram; the last is open")
          .real("bin_width", &Params::bin_width, 0.01, 256, "grey levels", "width of a bin of |X_0| / 8")
          .real("divisor_offset", &Params::divisor_offset, 0, 1000, "",
                "bins of X_k, k >= 1, are bin_width / (divisor_offset + divisor_slope k) wide")
          .real("divisor_slope", &Params::divisor_slope, 0.01, 1000, "", "see divisor_offset");
  return p;
}

const std::vector<RelationValue>& Fourier::values() const {
  static const std::vector<RelationValue> values{
      {"r_fo", 0, 1, "mean Bhattacharyya coefficient of the five Fourier histograms, 1 for equal ones"}};
  return values;
}

std::unique_ptr<Observation> Fourier::observe(const Images& images) const { return transform(images.grey(), params_); }

std::unique_ptr<Measure> Fourier::bind(const Scene& scene) const {
  return std::make_unique<FourierMeasure>(scene.observed<BinImages>(*this), scene.surfaces(), params_.bins);
}

}  // namespace gestalt
