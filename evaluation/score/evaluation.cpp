// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/score/evaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "gestalt/core/base/error.h"
#include "gestalt/core/pipeline/learning_set.h"
#include "gestalt/evaluation/score/assignment.h"

namespace gestalt {

namespace {

using Labels = cv::Mat_<std::uint16_t>;
using Counts = Eigen::Array<std::int64_t, Eigen::Dynamic, Eigen::Dynamic>;
using CountVector = Eigen::Array<std::int64_t, Eigen::Dynamic, 1>;

constexpr double boundary_tolerance = 0.003;  // of the image's diagonal
constexpr double detection_f = 0.75;

/// Areas of an image, numbered from 1 in the order of their labels.
struct Areas {
  Labels image;             // 0 = none
  std::vector<int> labels;  // of area i + 1

  int count() const { return int(labels.size()); }
};

/// The areas of an image by the label of each pixel.
Areas number_areas(Labels labels) {
  constexpr int label_count = std::numeric_limits<std::uint16_t>::max() + 1;
  std::vector<std::uint16_t> number(label_count, 0);
  for (const std::uint16_t label : labels) number[label] = 1;
  number[0] = 0;
  std::vector<int> used;
  for (int label = 1; label < label_count; ++label) {
    if (!number[std::size_t(label)]) continue;
    used.push_back(label);
    number[std::size_t(label)] = std::uint16_t(used.size());
  }
  for (std::uint16_t& label : labels) label = number[label];
  return {labels, used};
}

/// Shared pixels of every two areas; row and column 0 are the pixels in none.
Counts shared_pixels(const Areas& rows, const Areas& columns) {
  Counts counts = Counts::Zero(rows.count() + 1, columns.count() + 1);
  for (int v = 0; v < rows.image.rows; ++v)
    for (int u = 0; u < rows.image.cols; ++u) ++counts(rows.image(v, u), columns.image(v, u));
  return counts;
}

double ratio_or_one(std::int64_t part, std::int64_t whole) { return whole ? double(part) / double(whole) : 1.0; }

double harmonic_mean(double a, double b) { return a + b > 0 ? 2 * a * b / (a + b) : 0.0; }

/// Counts of each row with its best segment (column): the one that shares most pixels with it, the first of equal ones.
std::vector<PooledPixels> match_each(const Counts& shared, const CountVector& region_area,
                                     const CountVector& segment_area) {
  std::vector<PooledPixels> each(std::size_t(shared.rows()));
  for (Eigen::Index i = 0; i < shared.rows(); ++i) {
    PooledPixels& counts = each[std::size_t(i)];
    counts.region = region_area[i];
    if (shared.cols() == 0) continue;
    Eigen::Index best;
    const std::int64_t common = shared.row(i).maxCoeff(&best);
    if (common == 0) continue;
    counts.true_positive = common;
    counts.false_positive = segment_area[best] - common;
  }
  return each;
}

PooledPixels pool(const std::vector<PooledPixels>& each) {
  PooledPixels pooled;
  for (const PooledPixels& counts : each) pooled += counts;
  return pooled;
}

/// The outer contours of areas, and the zones around them that count as the same place.
struct Boundaries {
  Labels lines;  // area number on its contour
  CountVector length;
  struct Zone {
    cv::Rect window;
    cv::Mat_<std::uint8_t> mask;  // of the window
  };
  std::vector<Zone> zones;
};

std::vector<cv::Rect> bounding_boxes(const Areas& areas) {
  std::vector<cv::Rect> boxes(std::size_t(areas.count()));
  for (int v = 0; v < areas.image.rows; ++v)
    for (int u = 0; u < areas.image.cols; ++u)
      if (const int area = areas.image(v, u)) boxes[std::size_t(area - 1)] |= cv::Rect(u, v, 1, 1);
  return boxes;
}

cv::Mat_<std::uint8_t> disk(int radius) {
  cv::Mat_<std::uint8_t> kernel(2 * radius + 1, 2 * radius + 1);
  for (int y = -radius; y <= radius; ++y)
    for (int x = -radius; x <= radius; ++x) kernel(y + radius, x + radius) = x * x + y * y <= radius * radius;
  return kernel;
}

Boundaries trace_boundaries(const Areas& areas) {
  const int radius = int(std::ceil(boundary_tolerance * cv::norm(cv::Point(areas.image.size()))));
  const cv::Mat_<std::uint8_t> kernel = disk(radius);
  const cv::Rect image({0, 0}, areas.image.size());
  Boundaries boundaries{Labels(areas.image.size(), 0), CountVector(areas.count()), {}};
  int area = 0;
  for (const cv::Rect& box : bounding_boxes(areas)) {
    ++area;
    const cv::Rect window = (box - cv::Point(radius, radius) + cv::Size(2 * radius, 2 * radius)) & image;
    const cv::Mat mask = areas.image(window) == area;
    std::vector<std::vector<cv::Point>> contours;
    cv::findContours(mask, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    cv::Mat_<std::uint8_t> line(window.size(), 0);
    cv::drawContours(line, contours, -1, 1);
    boundaries.lines(window).setTo(area, line);
    boundaries.length[area - 1] = cv::countNonZero(line);
    cv::dilate(line, line, kernel);
    boundaries.zones.push_back({window, line});
  }
  return boundaries;
}

/// Contour pixels of each area of b (columns) within the zone of each area of a (rows).
Counts pixels_in_zones(const Boundaries& a, const Boundaries& b) {
  Counts counts = Counts::Zero(Eigen::Index(a.zones.size()), b.length.size() + 1);
  for (std::size_t i = 0; i < a.zones.size(); ++i) {
    const auto& [window, mask] = a.zones[i];
    const Labels lines = b.lines(window);
    for (int v = 0; v < window.height; ++v)
      for (int u = 0; u < window.width; ++u)
        if (mask(v, u)) ++counts(Eigen::Index(i), lines(v, u));
  }
  return counts.rightCols(b.length.size());
}

/// Everything about regions (rows) and segments (columns) that overlap and boundary values are made of.
struct Comparison {
  Counts shared;
  CountVector region_area, segment_area;
  CountVector region_length, segment_length;  // of the boundaries
  Counts segment_line_in_region_zone, region_line_in_segment_zone;
};

Comparison compare(const Areas& regions, const Areas& segments) {
  const Counts pixels = shared_pixels(regions, segments);
  const Boundaries of_regions = trace_boundaries(regions), of_segments = trace_boundaries(segments);
  return {pixels.bottomRightCorner(regions.count(), segments.count()),
          pixels.rowwise().sum().tail(regions.count()),
          pixels.colwise().sum().transpose().tail(segments.count()),
          of_regions.length,
          of_segments.length,
          pixels_in_zones(of_regions, of_segments),
          pixels_in_zones(of_segments, of_regions).transpose()};
}

/// Values of the regions and those segments that are foreground (indices, ascending).
OverlapBoundary overlap_boundary(const Comparison& all, const std::vector<int>& foreground) {
  const Eigen::Index regions = all.shared.rows();
  if (regions == 0 && foreground.empty()) return {1, 1, 1, 1, 1, 1, 1};
  if (foreground.empty()) return {1, 0, 0, 1, 0, 0, 0};
  if (regions == 0) return {0, 1, 0, 0, 1, 0, 0};

  const CountVector segment_area = all.segment_area(foreground);
  Eigen::MatrixXd f(regions, segment_area.size());
  for (Eigen::Index j = 0; j < f.cols(); ++j)
    for (Eigen::Index i = 0; i < f.rows(); ++i)
      f(i, j) = 2.0 * double(all.shared(i, foreground[std::size_t(j)])) / double(all.region_area[i] + segment_area[j]);

  std::int64_t shared = 0, precise = 0, recalled = 0, detected = 0;
  for (const auto& [region, column] : largest_assignment(f)) {
    const int segment = foreground[std::size_t(column)];
    shared += all.shared(region, segment);
    precise += all.segment_line_in_region_zone(region, segment);
    recalled += all.region_line_in_segment_zone(region, segment);
    detected += f(region, column) > detection_f;
  }
  OverlapBoundary values;
  values.overlap_precision = ratio_or_one(shared, segment_area.sum());
  values.overlap_recall = ratio_or_one(shared, all.region_area.sum());
  values.overlap_f = harmonic_mean(values.overlap_precision, values.overlap_recall);
  values.boundary_precision = ratio_or_one(precise, CountVector(all.segment_length(foreground)).sum());
  values.boundary_recall = ratio_or_one(recalled, all.region_length.sum());
  values.boundary_f = harmonic_mean(values.boundary_precision, values.boundary_recall);
  values.detected = double(detected) / double(regions);
  return values;
}

/// The segments that a rule leaves as foreground.
std::vector<int> foreground_segments(const CountVector& on_background, const CountVector& area, BackgroundRule rule) {
  Eigen::Index largest = -1;
  if (area.size() > 0) area.maxCoeff(&largest);
  std::vector<int> foreground;
  for (int i = 0; i < int(area.size()); ++i) {
    const bool mostly_background = 2 * on_background[i] > area[i];
    const bool background = rule == BackgroundRule::majority  ? mostly_background
                            : rule == BackgroundRule::largest ? i == largest
                            : rule == BackgroundRule::table   ? i == largest && mostly_background
                                                              : false;
    if (!background) foreground.push_back(i);
  }
  return foreground;
}

/// shared: parts x segments, of the parts that count.
PartScore score_parts(const Counts& shared, const CountVector& part_area, const CountVector& segment_area) {
  const PooledPixels pooled = pool(match_each(shared, part_area, segment_area));
  if (pooled.region == 0) {
    constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
    return {undefined, undefined, undefined};
  }
  double weighted = 0;
  for (Eigen::Index i = 0; i < shared.rows(); ++i) {
    double best = 0;
    for (Eigen::Index j = 0; j < shared.cols(); ++j)
      best = std::max(best, double(shared(i, j)) / double(part_area[i] + segment_area[j] - shared(i, j)));
    weighted += double(part_area[i]) * best;
  }
  const auto total = double(pooled.region);
  return {weighted / total, 1 - double(pooled.true_positive) / total, double(pooled.false_positive) / total};
}

void check_images(const Labels& ground_truth, const Labels& prediction) {
  const auto size = [](const Labels& image) {
    return std::to_string(image.cols) + "x" + std::to_string(image.rows) + " pixels";
  };
  if (ground_truth.empty() || prediction.size() != ground_truth.size())
    throw InputError("the prediction has " + size(prediction) + ", the ground truth " + size(ground_truth) +
                     "; both must have the same size");
}

}  // namespace

double PooledPixels::precision() const { return ratio_or_one(true_positive, true_positive + false_positive); }

double PooledPixels::recall() const { return ratio_or_one(true_positive, region); }

PooledPixels& PooledPixels::operator+=(const PooledPixels& other) {
  true_positive += other.true_positive;
  false_positive += other.false_positive;
  region += other.region;
  return *this;
}

ImageScore score_image(const cv::Mat_<std::uint16_t>& ground_truth, const cv::Mat_<std::uint16_t>& prediction,
                       RegionKind kind) {
  check_images(ground_truth, prediction);
  const auto is_object = [](int label) { return object_of_label(label) > 1; };
  Labels counted_segments = prediction.clone(), foreground = ground_truth.clone();
  counted_segments.setTo(0, ground_truth == 0);
  for (std::uint16_t& label : foreground)
    label = std::uint16_t(!is_object(label) ? 0 : kind == RegionKind::parts ? label : object_of_label(label));
  const Areas segments = number_areas(counted_segments);
  const Areas parts = number_areas(ground_truth.clone());
  const Areas regions = number_areas(foreground);
  const Comparison comparison = compare(regions, segments);

  ImageScore score;
  score.each = match_each(comparison.shared, comparison.region_area, comparison.segment_area);
  score.pooled = pool(score.each);
  score.regions = regions.count();
  score.segments = segments.count();

  const CountVector on_objects = comparison.shared.colwise().sum().transpose();
  for (std::size_t rule = 0; rule < score.overlap_boundary.size(); ++rule)
    score.overlap_boundary[rule] = overlap_boundary(
        comparison,
        foreground_segments(comparison.segment_area - on_objects, comparison.segment_area, BackgroundRule(rule)));

  const Counts pixels = shared_pixels(parts, segments).bottomRows(parts.count());
  std::vector<int> all, objects;
  for (int i = 0; i < parts.count(); ++i) {
    all.push_back(i);
    if (is_object(parts.labels[std::size_t(i)])) objects.push_back(i);
  }
  const auto score_of = [&](const std::vector<int>& rows) {
    const Counts chosen = pixels(rows, Eigen::all);
    return score_parts(chosen.rightCols(segments.count()), chosen.rowwise().sum(), comparison.segment_area);
  };
  score.all_parts = score_of(all);
  score.object_parts = score_of(objects);
  return score;
}

}  // namespace gestalt
