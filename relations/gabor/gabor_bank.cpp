// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gabor_bank.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <functional>
#include <numbers>
#include <opencv2/core/hal/intrin.hpp>
#include <opencv2/imgproc.hpp>

#include "gestalt/core/base/wide.h"

namespace gestalt {

namespace {

/// Columns that are filtered together, in registers.
constexpr int block = 16;
constexpr int lanes = cv::v_float32x4::nlanes;

int rounded_up(int value, int step) { return (value + step - 1) / step * step; }

/// One factor of a kernel, g(d) exp(i k d) for d = -radius..radius, as its even real and its odd imaginary part.
struct Factor {
  std::vector<float> even, odd;  // for d = 0..radius

  Factor(double wave_number, double deviation, int radius, bool dc_free) {
    std::vector<double> gauss;
    double total = 0, dc = 0;
    for (int d = 0; d <= radius; ++d) {
      gauss.push_back(std::exp(-0.5 * d * d / (deviation * deviation)));
      const double both_sides = d == 0 ? gauss.back() : 2 * gauss.back();
      total += both_sides;
      dc += both_sides * std::cos(wave_number * d);
    }
    const double offset = dc_free ? dc / total : 0;
    for (int d = 0; d <= radius; ++d) {
      even.push_back(float(gauss[std::size_t(d)] / total * (std::cos(wave_number * d) - offset)));
      odd.push_back(float(gauss[std::size_t(d)] / total * std::sin(wave_number * d)));
    }
  }
  int radius() const { return int(even.size()) - 1; }
};

/// A round Gaussian makes every kernel the product of a factor along x and one along y. Directions theta and pi - theta
/// differ in the sign of the x factor's imaginary part only and share all sums.
struct MirroredKernels {
  int direction;         // theta, in [0, pi / 2]
  int mirror_direction;  // pi - theta; equal to direction where that is the same filter
  Factor x, y;
};

struct Scale {
  int radius;
  std::vector<MirroredKernels> kernels;
};

std::vector<Scale> make_scales(const GaborBank& bank) {
  std::vector<Scale> scales;
  for (int i = 0; i < bank.scales; ++i) {
    const double k = bank.wave_number(i), deviation = bank.deviation(i);
    const int radius = bank.radius(i);
    Scale scale{radius, {}};
    for (int j = 0; j <= bank.directions / 2; ++j) {
      const double theta = std::numbers::pi * j / bank.directions;
      // The product is free of DC when one factor is: the one with the faster wave, whose own DC is the smaller.
      const bool along_x = 4 * j <= bank.directions;
      scale.kernels.push_back({j, j == 0 ? 0 : bank.directions - j,
                               Factor(k * std::cos(theta), deviation, radius, along_x),
                               Factor(k * std::sin(theta), deviation, radius, !along_x)});
    }
    scales.push_back(std::move(scale));
  }
  return scales;
}

/// Neighbouring grid pixels [first, last) of one grid row that count for one surface.
struct Run {
  int surface;
  int first;
  int last;
};

/// The grid pixels of all surfaces.
struct Grid {
  std::vector<std::vector<Run>> runs;  // of each grid row
  std::vector<int> counts;             // grid pixels of each surface

  Grid(const SurfaceSet& surfaces, int stride)
      : runs(std::size_t(rounded_up(surfaces.labels.rows, stride) / stride)), counts(surfaces.surfaces.size()) {
    for (int row = 0; row < int(runs.size()); ++row) {
      const int* labels = surfaces.labels[row * stride];
      for (int column = 0; column * stride < surfaces.labels.cols; ++column)
        if (const int label = labels[std::ptrdiff_t(column) * stride]) add(label - 1, row, column);
    }
    for (std::size_t i = 0; i < counts.size(); ++i) {
      if (counts[i] != 0) continue;
      for (const int pixel : surfaces.surfaces[i].pixels)
        add(int(i), pixel / surfaces.labels.cols / stride, pixel % surfaces.labels.cols / stride);
    }
  }

 private:
  void add(int surface, int row, int column) {
    std::vector<Run>& line = runs[std::size_t(row)];
    if (!line.empty() && line.back().surface == surface && line.back().last == column)
      ++line.back().last;
    else
      line.push_back({surface, column, column + 1});
    ++counts[std::size_t(surface)];
  }
};

/// The part of the grey image that the filters see, as float, with a margin around it. The columns of a row are sorted
/// by their remainder modulo stride, so that grid pixels, and pixels at one distance from them, are neighbours in
/// memory.
class SortedImage {
 public:
  SortedImage(const cv::Mat& grey, const cv::Rect& box, int stride, int radius)
      : stride_(stride),
        margin_(rounded_up(radius, stride)),
        segment_(rounded_up(rounded_up(box.width, block) + 2 * margin_ / stride, block)),
        pixels_(((box.height - 1) * stride + 1) + 2 * margin_, segment_ * stride) {
    std::vector<int> source(std::size_t(pixels_.cols));
    for (int i = 0; i < pixels_.cols; ++i) {
      const int u = (box.x + i % segment_) * stride + i / segment_ - margin_;
      source[std::size_t(i)] = cv::borderInterpolate(u, grey.cols, cv::BORDER_REFLECT_101);
    }
    for (int row = 0; row < pixels_.rows; ++row) {
      const int v = box.y * stride + row - margin_;
      const uchar* from = grey.ptr(cv::borderInterpolate(v, grey.rows, cv::BORDER_REFLECT_101));
      float* to = pixels_[row];
      for (int i = 0; i < pixels_.cols; ++i) to[i] = from[source[std::size_t(i)]];
    }
  }

  int row_length() const { return pixels_.cols; }
  const float* grid_row(int row) const { return pixels_[row * stride_ + margin_]; }

  /// Place of the first grid pixel in a row.
  int first() const { return margin_ / stride_; }
  /// Steps in memory from a pixel to the one d rows below it, d = -radius..radius.
  std::ptrdiff_t vertical(int d) const { return std::ptrdiff_t(d) * row_length(); }
  /// Steps in memory from a grid pixel to the one d columns to the right of it, d = -radius..radius.
  std::ptrdiff_t horizontal(int d) const {
    const int u = margin_ + d;
    return std::ptrdiff_t(u % stride_) * segment_ + u / stride_ - first();
  }

 private:
  int stride_, margin_, segment_;
  cv::Mat_<float> pixels_;
};

/// Memory steps to the two taps at each distance 0..radius.
struct Taps {
  std::vector<std::ptrdiff_t> forward, backward;

  template <class Step>
  Taps(int radius, Step step) {
    for (int d = 0; d <= radius; ++d) {
      forward.push_back(step(d));
      backward.push_back(step(-d));
    }
  }
};

/// Sums of f(x + d) even(d) and of f(x + d) odd(d), over d = -radius..radius, at a block of neighbouring x.
GESTALT_WIDE void filter_block(const float* f, const Taps& taps, const Factor& factor, float* even_sum,
                               float* odd_sum) {
  constexpr std::size_t parts = block / wide_lanes;
  const auto load = [](const float* from, WideFloats& to) { std::memcpy(&to, from, sizeof to); };
  WideFloats even[parts], odd[parts];
  for (std::size_t l = 0; l < parts; ++l) {
    load(f + l * wide_lanes, even[l]);
    even[l] *= factor.even[0];
    odd[l] = WideFloats{};
  }
  const std::size_t end = factor.even.size();
  for (std::size_t d = 1; d < end; ++d) {
    const float* forward = f + taps.forward[d];
    const float* backward = f + taps.backward[d];
    const float e = factor.even[d], o = factor.odd[d];
    for (std::size_t l = 0; l < parts; ++l) {
      WideFloats p, m;
      load(forward + l * wide_lanes, p);
      load(backward + l * wide_lanes, m);
      even[l] += (p + m) * e;
      odd[l] += (p - m) * o;
    }
  }
  std::memcpy(even_sum, even, sizeof even);
  std::memcpy(odd_sum, odd, sizeof odd);
}

/// Magnitudes of a kernel and its mirror image: | (a + i b) (c +- i s) | from the four products' sums over a block.
inline void magnitudes(const float* ac, const float* as, const float* bc, const float* bs, float* direct,
                       float* mirror) {
  for (int l = 0; l < block; l += lanes) {
    const auto re_re = cv::v_load(ac + l), re_im = cv::v_load(as + l);
    const auto im_re = cv::v_load(bc + l), im_im = cv::v_load(bs + l);
    cv::v_store(direct + l, cv::v_magnitude(re_re - im_im, re_im + im_re));
    cv::v_store(mirror + l, cv::v_magnitude(re_re + im_im, im_re - re_im));
  }
}

/// Sums over grid pixels of every filter's magnitude and of its square, surface after surface.
struct Sums {
  std::vector<double> first, second;

  explicit Sums(std::size_t size) : first(size), second(size) {}

  void add(std::size_t i, const float* values, int count) {
    double sum[lanes] = {}, square[lanes] = {};
    int n = 0;
    for (; n + lanes <= count; n += lanes)
      for (int l = 0; l < lanes; ++l) {
        const double value = values[n + l];
        sum[l] += value;
        square[l] += value * value;
      }
    for (; n < count; ++n) {
      const double value = values[n];
      sum[0] += value;
      square[0] += value * value;
    }
    for (int l = 0; l < lanes; ++l) {
      first[i] += sum[l];
      second[i] += square[l];
    }
  }

  Sums& operator+=(const Sums& other) {
    std::transform(first.begin(), first.end(), other.first.begin(), first.begin(), std::plus<>());
    std::transform(second.begin(), second.end(), other.second.begin(), second.begin(), std::plus<>());
    return *this;
  }
};

/// Filters grid rows, one scale at a time: first along y, all columns, then along x at the grid's columns.
class RowFilter {
 public:
  RowFilter(const GaborBank& bank, const SortedImage& image, int columns)
      : image_(image),
        columns_(columns),
        vertical_(std::size_t(2 * image.row_length()) * std::size_t(bank.directions / 2 + 1)) {}

  /// Of a row of the box; result: for each direction the row that the result is written to, which has room for a
  /// multiple of a block.
  void operator()(const Scale& scale, int row, const std::vector<float*>& result) {
    const float* pixels = image_.grid_row(row);
    const Taps down(scale.radius, [&](int d) { return image_.vertical(d); });
    for (int i = 0; i < image_.row_length(); i += block)
      for (std::size_t n = 0; n < scale.kernels.size(); ++n)
        filter_block(pixels + i, down, scale.kernels[n].y, real(n) + i, imaginary(n) + i);

    const Taps right(scale.radius, [&](int d) { return image_.horizontal(d); });
    for (std::size_t n = 0; n < scale.kernels.size(); ++n) {
      const MirroredKernels& kernels = scale.kernels[n];
      for (int i = 0; i < columns_; i += block) {
        float ac[block], as[block], bc[block], bs[block];
        filter_block(real(n) + image_.first() + i, right, kernels.x, ac, as);
        filter_block(imaginary(n) + image_.first() + i, right, kernels.x, bc, bs);
        magnitudes(ac, as, bc, bs, result[std::size_t(kernels.direction)] + i,
                   result[std::size_t(kernels.mirror_direction)] + i);
      }
    }
  }

 private:
  float* real(std::size_t n) { return &vertical_[2 * n * std::size_t(image_.row_length())]; }
  float* imaginary(std::size_t n) { return real(n) + image_.row_length(); }

  const SortedImage& image_;
  int columns_;
  std::vector<float> vertical_;
};

}  // namespace

double GaborBank::wave_number(int scale) const {
  return 2 * std::numbers::pi / (shortest_wavelength * std::pow(spacing, scale));
}

double GaborBank::deviation(int scale) const { return sigma / wave_number(scale); }

int GaborBank::radius(int scale) const { return std::max(1, int(std::lround(truncation * deviation(scale)))); }

GaborResponses::GaborResponses(const GaborBank& bank, const cv::Mat& grey, const cv::Rect& box)
    : box_(box), filters_(int(bank.filters())), magnitudes_(box.height * filters_, rounded_up(box.width, block)) {
  if (box.empty()) return;
  const std::vector<Scale> scales = make_scales(bank);
  const SortedImage image(grey, box, bank.stride, scales.back().radius);
  tbb::parallel_for(tbb::blocked_range<int>(0, box.height, 8), [&](const tbb::blocked_range<int>& rows) {
    RowFilter filter(bank, image, box.width);
    std::vector<float*> result(std::size_t(bank.directions));
    for (int row = rows.begin(); row < rows.end(); ++row)
      for (int i = 0; i < bank.scales; ++i) {
        for (int j = 0; j < bank.directions; ++j)
          result[std::size_t(j)] = magnitudes_[row * filters_ + i * bank.directions + j];
        filter(scales[std::size_t(i)], row, result);
      }
  });
}

cv::Rect grid_box(const cv::Mat& mask, int stride) {
  const cv::Rect box = cv::boundingRect(mask);
  if (box.empty()) return {};
  const cv::Point first = box.tl() / stride, last = (box.br() - cv::Point(1, 1)) / stride;
  return {first, last + cv::Point(1, 1)};
}

std::vector<GaborDescriptor> describe(const GaborBank& bank, const GaborResponses& responses,
                                      const SurfaceSet& surfaces) {
  const Grid grid(surfaces, bank.stride);
  const std::size_t filters = bank.filters();
  const Sums none(surfaces.surfaces.size() * filters);
  // The reduction splits the rows the same way for any number of threads.
  const Sums sums = tbb::parallel_deterministic_reduce(
      tbb::blocked_range<int>(0, int(grid.runs.size()), 16), none,
      [&](const tbb::blocked_range<int>& rows, Sums partial) {
        for (int row = rows.begin(); row < rows.end(); ++row)
          for (const Run& run : grid.runs[std::size_t(row)])
            for (std::size_t f = 0; f < filters; ++f)
              partial.add(std::size_t(run.surface) * filters + f, responses.at(row, f, run.first),
                          run.last - run.first);
        return partial;
      },
      [](Sums left, const Sums& right) { return std::move(left += right); });

  std::vector<GaborDescriptor> descriptors(surfaces.surfaces.size());
  for (std::size_t i = 0; i < descriptors.size(); ++i)
    for (std::size_t f = i * filters; f < (i + 1) * filters; ++f) {
      const double mean = sums.first[f] / grid.counts[i];
      descriptors[i].mean.push_back(float(mean));
      descriptors[i].deviation.push_back(
          float(std::sqrt(std::max(0.0, sums.second[f] / grid.counts[i] - mean * mean))));
    }
  return descriptors;
}

}  // namespace gestalt
