// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "coco_labels.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/json_file.h"

namespace gestalt {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::uintmax_t largest_file = std::uintmax_t{1} << 28;  // bytes
constexpr std::size_t most_annotations = 6552;

using Mask = cv::Mat_<std::uint8_t>;

[[noreturn]] void fail(const std::string& what) { throw InputError(what); }

double number(const json& value) {
  if (!value.is_number()) fail("expected a number");
  return value.get<double>();
}

/// What drawing all objects of a file may still cost: a few bytes can have every pixel of a large image drawn, again
/// and again.
struct Budget {
  std::int64_t steps = std::int64_t{1} << 30;

  void spend(std::int64_t count) {
    steps -= count;
    if (steps < 0)
      fail("has too many polygon corners and pixels to draw; keep the objects of this image only, and " +
           std::string("smaller ones"));
  }
};

/// Pixels column by column, outside and inside in turn.
void fill_runs(Mask& mask, const std::vector<std::int64_t>& runs, Budget& budget) {
  std::int64_t pixel = 0;
  const auto all = std::int64_t(mask.total());
  bool inside = false;
  for (const std::int64_t run : runs) {
    if (run < 0 || run > all - pixel) fail("its counts are more than the image's pixels");
    if (inside) budget.spend(run);
    if (inside)
      for (std::int64_t i = pixel; i < pixel + run; ++i) mask(int(i % mask.rows), int(i / mask.rows)) = 255;
    pixel += run;
    inside = !inside;
  }
  if (pixel != all) fail("its counts are fewer than the image's pixels");
}

/// Run lengths as pycocotools packs them: six bits a character from '0', of which the sixth says that more follow; from
/// the third on as differences to the last but one.
std::vector<std::int64_t> unpack(const std::string& text) {
  std::vector<std::int64_t> runs;
  for (std::size_t i = 0; i < text.size();) {
    std::int64_t value = 0;
    int shift = 0;
    bool more = true;
    while (more) {
      if (i == text.size() || shift > 30) fail("its packed counts are damaged");
      const int bits = text[i++] - '0';
      if (bits < 0 || bits > 63) fail("its packed counts are damaged");
      value |= std::int64_t{bits & 31} << shift;
      shift += 5;
      more = bits & 32;
      if (!more && (bits & 16)) value -= std::int64_t{1} << shift;
    }
    if (runs.size() > 2) value += runs[runs.size() - 2];
    runs.push_back(value);
  }
  return runs;
}

/// The pixels whose centres lie in the polygon; coordinates count from a pixel's corner.
void fill_polygon(Mask& mask, const json& polygon, Budget& budget) {
  if (polygon.size() < 6 || polygon.size() % 2)
    fail("a polygon must have at least three corners, as x1, y1, x2, y2, ...");
  std::vector<cv::Point2d> corners;
  for (std::size_t i = 0; i < polygon.size(); i += 2) corners.emplace_back(number(polygon[i]), number(polygon[i + 1]));
  std::vector<double> crossings;
  budget.spend(std::int64_t(corners.size()) * mask.rows);
  for (int v = 0; v < mask.rows; ++v) {
    const double y = v + 0.5;
    crossings.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const cv::Point2d& a = corners[i];
      const cv::Point2d& b = corners[(i + 1) % corners.size()];
      if ((a.y <= y) != (b.y <= y)) crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const int first = int(std::clamp(std::ceil(crossings[i] - 0.5), 0.0, double(mask.cols)));
      const int last = int(std::clamp(std::ceil(crossings[i + 1] - 0.5), 0.0, double(mask.cols)));
      budget.spend(std::max(0, last - first));
      for (int u = first; u < last; ++u) mask(v, u) = 255;
    }
  }
}

Mask mask_of(const json& segmentation, cv::Size size, Budget& budget) {
  constexpr int at_once = 16;  // bytes that are cleared in a step
  budget.spend(size.area() / at_once);
  Mask mask(size, std::uint8_t{0});
  if (segmentation.is_array()) {
    for (const json& polygon : segmentation) {
      if (!polygon.is_array()) fail("a polygon must be a list of numbers");
      fill_polygon(mask, polygon, budget);
    }
    return mask;
  }
  if (!segmentation.is_object() || !segmentation.contains("counts"))
    fail("has no segmentation, neither polygons nor counts");
  const json extent = segmentation.value("size", json());
  if (extent != json({size.height, size.width})) fail("its segmentation differs in size from the image");
  const json& counts = segmentation.at("counts");
  std::vector<std::int64_t> runs;
  if (counts.is_string()) {
    runs = unpack(counts.get<std::string>());
  } else if (counts.is_array()) {
    for (const json& count : counts) {
      if (!count.is_number_integer()) fail("its counts must be whole numbers");
      runs.push_back(count.get<std::int64_t>());
    }
  } else {
    fail("its counts are neither a list nor a string");
  }
  fill_runs(mask, runs, budget);
  return mask;
}

/// The id of the image that is meant.
json image_id(const json& content, cv::Size size, const std::string& stem) {
  std::vector<json> fitting;
  for (const json& image : content.at("images")) {
    if (!image.is_object() || image.value("width", json()) != size.width ||
        image.value("height", json()) != size.height)
      continue;
    const json name = image.value("file_name", json());
    if (name.is_string() && fs::path(name.get<std::string>()).stem() == stem) return image.value("id", json());
    fitting.push_back(image.value("id", json()));
  }
  if (fitting.size() != 1)
    fail("has " + std::to_string(fitting.size()) + " images of " + std::to_string(size.width) + "x" +
         std::to_string(size.height) + "; keep the one of this scene, or name it " + stem);
  return fitting[0];
}

}  // namespace

cv::Mat_<int> read_coco_labels(const fs::path& file, cv::Size size, const std::string& stem) try {
  const json content = read_json(file, largest_file);
  const auto has_list = [&](const char* key) { return content.contains(key) && content.at(key).is_array(); };
  if (!content.is_object() || !has_list("images") || !has_list("annotations"))
    fail("is not a COCO file: it has no lists images and annotations");
  const json id = image_id(content, size, stem);
  std::vector<std::pair<int, int>> areas;  // of each object, with its number
  std::vector<const json*> segmentations;
  Budget budget;
  int number = 0;
  for (const json& annotation : content.at("annotations")) {
    if (!annotation.is_object() || annotation.value("image_id", json()) != id) continue;
    if (annotation.value("iscrowd", json(0)) == 1) continue;
    if (segmentations.size() == most_annotations)
      fail("has more than " + std::to_string(most_annotations) + " objects");
    segmentations.push_back(&annotation);
    ++number;
    try {
      areas.emplace_back(-cv::countNonZero(mask_of(annotation.value("segmentation", json()), size, budget)), number);
    } catch (const InputError& error) {
      fail("annotation " + std::to_string(number) + ": " + error.what());
    }
  }
  std::stable_sort(areas.begin(), areas.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  cv::Mat_<int> labels(size, 0);
  for (const auto& [area, object] : areas)
    labels.setTo(object, mask_of(segmentations[std::size_t(object - 1)]->at("segmentation"), size, budget));
  return labels;
} catch (const InputError& error) {
  const std::string what = error.what();
  throw InputError(what.starts_with(file.string()) ? what : file.string() + ": " + what);
}

}  // namespace gestalt
