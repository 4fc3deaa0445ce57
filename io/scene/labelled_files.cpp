// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/labelled_files.h"

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "point_cloud.h"

namespace gestalt {

namespace {

using Labels = cv::Mat_<std::uint16_t>;
using Json = nlohmann::ordered_json;

template <class T>
void append(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// What is known of one label.
struct Instance {
  int left = std::numeric_limits<int>::max(), top = left, right = -1, bottom = -1;
  std::int64_t area = 0;
  std::vector<std::int64_t> runs;  ///< in turn outside and inside, column by column
  std::int64_t end = 0;            ///< of the last run inside

  void add(int u, int v, std::int64_t index) {
    left = std::min(left, u), right = std::max(right, u);
    top = std::min(top, v), bottom = std::max(bottom, v);
    ++area;
    if (runs.empty() || index > end) {
      runs.push_back(index - end);
      runs.push_back(0);
    }
    ++runs.back();
    end = index + 1;
  }
};

Json annotation_of(int label, const Instance& instance, cv::Size size) {
  std::vector<std::int64_t> runs = instance.runs;
  const std::int64_t pixels = std::int64_t(size.width) * size.height;
  if (instance.end < pixels) runs.push_back(pixels - instance.end);
  return {
      {"id", label},
      {"image_id", 1},
      {"category_id", 1},
      {"iscrowd", 0},
      {"area", instance.area},
      {"bbox", {instance.left, instance.top, instance.right - instance.left + 1, instance.bottom - instance.top + 1}},
      {"segmentation", {{"size", {size.height, size.width}}, {"counts", runs}}}};
}

}  // namespace

std::string encode_pcd(const Frame& frame, const Labels& labels) {
  PointCloud cloud;
  cloud.width = frame.width();
  cloud.height = frame.height();
  cloud.points.assign(frame.points.begin(), frame.points.end());
  std::size_t i = 0;
  for (const float depth : frame.depth) {
    if (!(depth > 0)) cloud.points[i] = cv::Vec3f::all(std::numeric_limits<float>::quiet_NaN());
    ++i;
  }
  if (frame.has_colour()) cloud.colours.assign(frame.colour.begin<cv::Vec3b>(), frame.colour.end<cv::Vec3b>());
  if (!labels.empty()) cloud.labels.assign(labels.begin(), labels.end());
  return encode_pcd(cloud);
}

std::string encode_ply(const Frame& frame, const Labels& labels) {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\ncomment metres, camera frame: x right, y down, z forward\n"
      "element vertex " +
      std::to_string(cv::countNonZero(frame.depth)) + "\nproperty float x\nproperty float y\nproperty float z\n";
  if (frame.has_colour()) bytes += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  if (!labels.empty()) bytes += "property ushort label\n";
  bytes += "end_header\n";
  for (int v = 0; v < frame.height(); ++v)
    for (int u = 0; u < frame.width(); ++u) {
      if (!(frame.depth(v, u) > 0)) continue;
      append(bytes, frame.points(v, u));
      if (frame.has_colour())
        for (const int channel : {2, 1, 0}) append(bytes, frame.colour.at<cv::Vec3b>(v, u)[channel]);
      if (!labels.empty()) append(bytes, labels(v, u));
    }
  return bytes;
}

Json coco_instances(const Labels& labels, const std::string& file_name) {
  std::map<int, Instance> instances;
  for (int u = 0; u < labels.cols; ++u)
    for (int v = 0; v < labels.rows; ++v)
      if (const int label = labels(v, u)) instances[label].add(u, v, std::int64_t(u) * labels.rows + v);
  Json annotations = Json::array();
  for (const auto& [label, instance] : instances) annotations.push_back(annotation_of(label, instance, labels.size()));
  const Json image{{"id", 1}, {"file_name", file_name}, {"width", labels.cols}, {"height", labels.rows}};
  const Json category{{"id", 1}, {"name", "object"}};
  return {{"images", Json::array({image})},
          {"categories", Json::array({category})},
          {"annotations", std::move(annotations)}};
}

}  // namespace gestalt
