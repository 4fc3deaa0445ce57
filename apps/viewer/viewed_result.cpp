// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "viewed_result.h"

#include <pcl/conversions.h>

#include <nlohmann/json.hpp>
#include <set>

#include "gestalt/core/base/error.h"
#include "gestalt/io/result/result.h"
#include "gestalt/io/result/result_digests.h"
#include "gestalt/io/result/result_file.h"
#include "gestalt/io/scene/input.h"

namespace gestalt::view {

namespace {

namespace fs = std::filesystem;

constexpr double tolerance = 0.001;  ///< m, of a surface's triangles
constexpr std::uint8_t grey = 190;   ///< of everything but objects, where there is no colour

/// Otherwise the cloud would take the intrinsics that lie near it.
Camera camera_of(const fs::path& file, const nlohmann::json& content) {
  try {
    const nlohmann::json& camera = content.at("camera");
    return Camera{camera.at("width"), camera.at("height"), camera.at("fx"),
                  camera.at("fy"),    camera.at("cx"),     camera.at("cy")};
  } catch (const nlohmann::json::exception&) {
    throw InputError(file.string() + ": has no camera; segment the scene again");
  }
}

Cloud::PointType point_of(const cv::Vec3f& at, const cv::Vec3b& colour) {
  return {at[0], at[1], at[2], colour[2], colour[1], colour[0]};
}

/// Background keeps its light and shade, but dimmed, so that objects stand out of it.
cv::Vec3b greyed(const cv::Vec3b& colour) {
  const auto light = std::uint8_t((int(colour[0]) + 2 * colour[1] + colour[2]) / 7);
  return {light, light, light};
}

void add_points(const Input& input, const std::set<int>& objects, ViewedResult& result) {
  const Frame& frame = input.frame;
  for (int v = 0; v < frame.height(); ++v)
    for (int u = 0; u < frame.width(); ++u) {
      if (!(frame.depth(v, u) > 0)) continue;
      const cv::Vec3b seen = frame.has_colour() ? frame.colour.at<cv::Vec3b>(v, u) : cv::Vec3b(grey, grey, grey);
      const int label = input.ground_truth(v, u);
      const cv::Vec3f& at = frame.points(v, u);
      const bool object = objects.count(label) > 0;
      result.segments->push_back(point_of(at, object ? segment_colour(label) : greyed(seen)));
      if (!object) result.background->push_back(result.segments->back());
      if (frame.has_colour()) result.colours->push_back(point_of(at, seen));
    }
}

pcl::PolygonMesh object_surfaces(const fs::path& file, const StoredResult& stored) try {
  Cloud vertices;
  pcl::PolygonMesh surfaces;
  TriangulationBudget budget;
  for (const StoredResult::Segment& segment : stored.segments) {
    if (segment.background) continue;
    const auto first = pcl::index_t(vertices.size());
    const Mesh mesh = triangulate(stored, segment, tolerance, budget);
    for (const Eigen::Vector3d& vertex : mesh.vertices)
      vertices.push_back(
          point_of({float(vertex.x()), float(vertex.y()), float(vertex.z())}, segment_colour(segment.label)));
    for (const auto& [a, b, c] : mesh.triangles) {
      surfaces.polygons.emplace_back();
      surfaces.polygons.back().vertices = {first + a, first + b, first + c};
    }
  }
  pcl::toPCLPointCloud2(vertices, surfaces.cloud);
  return surfaces;
} catch (const InputError& error) {
  throw InputError(file.string() + ": " + error.what());
}

}  // namespace

ViewedResult read_viewed_result(const fs::path& folder) {
  const fs::path file = folder / "result.json", cloud = folder / "labelled.pcd";
  const nlohmann::json content = read_result_content(file);
  const StoredResult stored = read_result(file);
  std::error_code ignored;
  if (!fs::exists(cloud, ignored))
    throw InputError(cloud.string() + ": does not exist; segment the scene with --also pcd");
  ReadOptions options = camera_of(file, content);
  options.labels = LabelScheme::osd;  // keeps the numbers of segments as they are
  const Input input = read_scene(cloud, options);
  if (const auto files = content.find("files");
      files != content.end() && files->is_object() && !files->contains(cloud.filename().string()))
    throw InputError(cloud.string() + ": comes from an earlier run; segment the scene again with --also pcd");
  // What was read first against what lies there now: somebody may have written both meanwhile.
  if (const std::string warning = warning_of_foreign_files(file, content); !warning.empty()) throw InputError(warning);
  if (input.ground_truth.empty()) throw InputError(cloud.string() + ": has no labels; segment the scene again");

  ViewedResult result{
      stored.scene, std::make_shared<Cloud>(), std::make_shared<Cloud>(), std::make_shared<Cloud>(), {}};
  std::set<int> objects;
  for (const StoredResult::Segment& segment : stored.segments)
    if (!segment.background) objects.insert(segment.label);
  add_points(input, objects, result);
  result.surfaces = object_surfaces(file, stored);
  return result;
}

}  // namespace gestalt::view
