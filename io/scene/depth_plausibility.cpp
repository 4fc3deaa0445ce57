// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/depth_plausibility.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

#include "gestalt/core/base/error.h"

namespace gestalt {

namespace {

constexpr int most_samples = 8000;
constexpr std::size_t few = 1000;  // samples: what fewer have in common may be chance

// Metres. No sensor for what stands on a table has nothing nearer than the first, or half of its image nearer than the
// second. Not half of it farther than the first: simulators have a sky.
constexpr double too_far = 40, too_near = 0.02;
// Mean second difference of neighbours over z^2, 1/m: stereo and structured light have 0.0005 and more at any depth, so
// that the same noise in a unit that is too large by k is k times less. Only of noise that the unit resolves, as what
// is rendered has none, and only of what is seen from afar.
constexpr double finest_far = 0.00045, far_nearest = 1.8, far_median = 2.5;
constexpr double finest = 0.00035, least_nearest = 1.0, least_median = 1.6;
constexpr double resolved = 1.2;  // units
constexpr double near_median = 0.15, near_farthest = 0.5;

std::string number(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  if (value >= 100)
    text << std::fixed << std::setprecision(0) << value;
  else
    text << std::setprecision(3) << value;
  return text.str();
}

/// What is asked of a depth image, from pixels on a grid.
class DepthSamples {
 public:
  explicit DepthSamples(const DepthReading& depth) : scale_(depth.unit.metres), whole_(depth.whole_numbers) {
    const cv::Mat_<float>& z = depth.metres;
    const int step = std::max(1, int(std::sqrt(double(z.total()) / most_samples)));
    double differences = 0, squares = 0, pairs = 0;
    for (int v = step / 2; v < z.rows; v += step)
      for (int u = step / 2; u < z.cols; u += step) {
        const double at = z(v, u);
        // Not what stands for "nothing" or "infinity": the largest of 16 bits, or of half precision, and beyond.
        if (!(at > 0 && at < 1e6 * scale_) || at == 65504 * scale_ || at == 65535 * scale_) continue;
        metres_.push_back(at);
        if (u == 0 || u + 1 == z.cols || !(z(v, u - 1) > 0 && z(v, u + 1) > 0)) continue;
        const double difference = std::abs(z(v, u - 1) - 2 * at + z(v, u + 1));
        if (!(difference < 0.03 * at)) continue;
        differences += difference;
        squares += at * at;
        ++pairs;
      }
    std::sort(metres_.begin(), metres_.end());
    fineness_ = squares > 0 ? differences / squares : 0;
    noise_ = pairs > 0 ? differences / pairs / scale_ : 0;
    const auto endless = float(1e6 * scale_), none = float(65535 * scale_);
    for (const float at : z)
      if (at > largest_ && at < endless && at != none) largest_ = at;
    for (std::size_t i = 0; i < metres_.size(); ++i) distinct_ += i == 0 || metres_[i] != metres_[i - 1];
  }

  std::size_t count() const { return metres_.size(); }
  std::size_t distinct() const { return distinct_; }
  bool whole() const { return whole_; }

  /// The noise is less than any sensor has so far away.
  bool too_fine() const {
    return noise_ > resolved && ((nearest() > far_nearest && median() > far_median && fineness_ < finest_far) ||
                                 (nearest() > least_nearest && median() > least_median && fineness_ < finest));
  }

  double median() const { return at(0.5); }
  double nearest() const { return at(0.05); }
  double farthest() const { return at(0.99); }
  float largest() const { return largest_; }                                     ///< metres
  double largest_unit() const { return std::round(double(largest_) / scale_); }  ///< in the file's numbers

  /// Share of the file's numbers that are whole multiples.
  double multiples_of(double divisor) const {
    const auto is_multiple = [&](double metres) {
      const double units = metres / scale_ / divisor;
      return std::abs(units - std::round(units)) < 1e-4 * std::max(1.0, units * 1e-2);
    };
    return double(std::count_if(metres_.begin(), metres_.end(), is_multiple)) / double(count());
  }

  /// "0.62 to 2.6 m" of the middle, were a unit so many metres.
  std::string range(double unit) const {
    const double factor = unit / scale_;
    return number(factor * nearest()) + " to " + number(factor * farthest()) + " m";
  }

 private:
  double at(double share) const { return metres_[std::size_t(share * double(metres_.size() - 1))]; }

  double scale_;
  bool whole_;
  std::vector<double> metres_;  ///< ascending
  std::size_t distinct_ = 0;
  double fineness_ = 0;  ///< mean second difference along rows over z^2, 1/m
  double noise_ = 0;     ///< the same difference in units
  float largest_ = 0;    ///< of all pixels
};

/// "--unit mm (0.62 to 2.6 m), --unit cm (6.2 to 26 m)": the units in which one sees something, the likeliest first.
std::string likely_units(const DepthSamples& samples, const DepthUnit& read) {
  struct Candidate {
    double metres, distance;
  };
  std::vector<Candidate> candidates;
  for (const double metres : {1.0, 1e-2, 1e-3, 2.5e-4, 2e-4, 1e-4, 1e-6, 1e3}) {
    const double median = samples.median() * metres / read.metres;
    if (std::abs(metres / read.metres - 1) > 0.01 && median > 0.2 && median < 12)
      candidates.push_back({metres, std::abs(std::log(median))});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  std::string text;
  for (const Candidate& candidate : candidates) {
    std::string unit = candidate.metres == 1e3 ? "km" : unit_name(candidate.metres);
    unit.erase(std::remove(unit.begin(), unit.end(), ' '), unit.end());
    text += (text.empty() ? "--unit " : ", --unit ") + unit + " (" + samples.range(candidate.metres) + ")";
  }
  return text.empty() ? "--depth-scale with the metres of a unit" : text;
}

/// Windows of the image in which the inverse of depth is affine, as it is on a plane, if depth is along the axis - or
/// if it is along the rays.
class Planes {
 public:
  Planes(const cv::Mat_<float>& depth, const Camera& camera) {
    const int width = std::min(depth.cols, depth.rows) / 4;
    if (width < 24) return;
    for (int top = 0; top + width <= depth.rows; top += width / 2)
      for (int left = 0; left + width <= depth.cols; left += width / 2) fit(depth, camera, left, top, width);
  }

  /// Nearly every plane is flatter along the rays. In depth along the axis hardly any is.
  bool radial() const { return planes_ >= 4 && flatter_radial_ >= 0.85 * planes_ && log_ratio_ / planes_ < -0.08; }

 private:
  void fit(const cv::Mat_<float>& depth, const Camera& camera, int left, int top, int width) {
    constexpr int side = 14;  // points
    Eigen::Matrix<double, side * side, 3> basis;
    Eigen::Matrix<double, side * side, 2> inverse;
    int n = 0;
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) {
        const int u = left + (j * (width - 1)) / (side - 1), v = top + (i * (width - 1)) / (side - 1);
        const double z = depth(v, u);
        if (!(z > 0 && z < 1e6)) continue;
        const double x = (u - camera.cx) / camera.fx, y = (v - camera.cy) / camera.fy;
        basis.row(n) << 1, (u - left) / double(width), (v - top) / double(width);
        inverse.row(n++) << 1 / z, std::sqrt(x * x + y * y + 1) / z;
      }
    if (n < 0.95 * side * side) return;
    const Eigen::MatrixX3d a = basis.topRows(n);
    const Eigen::MatrixX2d b = inverse.topRows(n);
    const Eigen::Matrix<double, 3, 2> solved = (a.transpose() * a).ldlt().solve(a.transpose() * b);
    const Eigen::RowVector2d residual =
        ((a * solved - b).colwise().squaredNorm() / n).cwiseSqrt().cwiseQuotient(b.colwise().mean());
    constexpr double flat = 0.004;
    if (!(residual.minCoeff() < flat) || residual.minCoeff() == 0) return;
    ++planes_;
    flatter_radial_ += residual[1] < residual[0];
    log_ratio_ += std::log(residual[1] / residual[0]);
  }

  double planes_ = 0, flatter_radial_ = 0, log_ratio_ = 0;
};

/// What whole numbers tell by their low bits and their number. Throws.
void question_numbers(const std::string& name, const DepthSamples& samples, const DepthUnit& unit) {
  const auto refuse = [&](const std::string& what) { throw InputError(name + ": " + what); };
  const bool millimetres = std::abs(unit.metres - 0.001) < 1e-5;
  if ((samples.whole() || samples.distinct() > 1) && samples.distinct() <= 40 && samples.largest_unit() <= 50 &&
      (!samples.whole() || samples.largest_unit() * unit.metres < 0.1) && samples.multiples_of(1) == 1)
    refuse("its depth has only whole numbers up to " + number(samples.largest_unit()) +
           ", so it is probably rounded to metres. Save it unrounded, as floats in metres or as numpy.uint16(1000 * "
           "depth)");
  if (samples.whole() && samples.largest_unit() > 257 &&
      std::max(samples.multiples_of(256), samples.multiples_of(257)) == 1)
    refuse("its depth has the " + std::to_string(samples.distinct()) +
           " values of an 8-bit picture stretched to 16 bits; save the sensor's depth, not a picture of it");
  if (samples.whole() && millimetres && samples.distinct() >= 50 && samples.multiples_of(8) > 0.9)
    refuse(
        "nearly all of its depth values are multiples of 8, as in SUN RGB-D, where the 16 bits are rotated by three; "
        "give "
        "--depth-kind rotated, or --unit mm if it really is in millimetres");
}

void question_range(const std::string& name, const DepthReading& depth, const DepthSamples& samples,
                    std::vector<std::string>& warnings) {
  const DepthUnit& unit = depth.unit;
  const std::string read =
      "its depth is " + samples.range(unit.metres) + " when read in " + unit_name(unit.metres) + " (" + unit.from + ")";
  const bool impossible = samples.nearest() > too_far || samples.median() < too_near;
  if (impossible && !unit.told)
    throw InputError(name + ": " + read + ", which is outside the range of depth sensors; give " +
                     likely_units(samples, unit));
  if (impossible) {
    warnings.push_back(name + ": " + read + ", which is outside the range of depth sensors");
    return;
  }
  if (unit.told || samples.count() < few) return;
  const std::string doubt = name + ": " + read;
  const std::string remedy = "; if that is wrong, give " + likely_units(samples, unit) + "; if it is right, --unit " +
                             (std::abs(unit.metres - 1) < 1e-6 ? "m" : "mm");
  const bool millimetres = depth.whole_numbers && std::abs(unit.metres - 0.001) < 1e-5;
  if (millimetres && samples.largest_unit() >= 64000 && samples.farthest() > 40) {
    warnings.push_back(
        doubt + ", up to " + number(samples.largest_unit()) +
        " of 65535: it seems to be scaled to the 16-bit range, so its unit is lost. Save the sensor's depth, or "
        "give --depth-scale with the metres of a unit, the farthest depth / 65535");
  } else if (millimetres && samples.too_fine()) {
    warnings.push_back(doubt + ", but finer than sensors are there" + remedy);
  } else if (millimetres && samples.median() < near_median && samples.farthest() < near_farthest) {
    warnings.push_back(doubt + ", very near" + remedy);
  } else if (!depth.whole_numbers && samples.nearest() > 6 && samples.median() > 12) {
    warnings.push_back(doubt + ", very far" + remedy);
  } else if (!depth.whole_numbers && samples.largest() == 1 && samples.multiples_of(0.001) < 0.5) {
    warnings.push_back(doubt +
                       ", and its largest value is 1: it seems to be scaled to 0..1; give --depth-scale with the "
                       "depth that 1 stands for, or --unit m if it is in metres");
  }
}

}  // namespace

void question_depth(const std::string& name, const DepthReading& depth, const Camera& camera,
                    std::vector<std::string>& warnings) {
  const DepthSamples samples(depth);
  if (samples.count() == 0) return;  // make_frame() says so
  if (!depth.unit.told && samples.count() >= few) question_numbers(name, samples, depth.unit);
  question_range(name, depth, samples, warnings);
  if (depth.kind == DepthKind::plain && Planes(depth.metres, camera).radial())
    warnings.push_back(name +
                       ": planes are curved in its depth, and flat when it is taken for the distance from the camera "
                       "along each pixel's ray; if it is, give --depth-kind radial");
}

}  // namespace gestalt
