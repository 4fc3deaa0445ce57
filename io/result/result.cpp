// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/result/result.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "gestalt/core/base/digest.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/isolated.h"
#include "gestalt/core/base/output_file.h"
#include "gestalt/core/scene/contour.h"
#include "gestalt/io/result/result_digests.h"
#include "gestalt/io/scene/png_codec.h"
#include "gestalt/io/scene/point_cloud.h"
#include "object_json.h"

namespace gestalt {

namespace {

using Json = nlohmann::json;

Json camera_json(const Camera& c) {
  return {{"width", c.width}, {"height", c.height}, {"fx", c.fx}, {"fy", c.fy}, {"cx", c.cx}, {"cy", c.cy}};
}

Json segments_json(const Segmentation& segmentation) {
  Json segments = Json::array();
  for (std::size_t i = 0; i < segmentation.segments.size(); ++i)
    segments.push_back({{"label", i + 1},
                        {"pixels", segmentation.segments[i].pixel_count},
                        {"role", name_of(segmentation.segments[i].role)},
                        {"patches", segmentation.segments[i].surfaces}});
  return segments;
}

/// To 10 micrometres, or as much of a B-spline's domain.
double rounded(double value) { return std::round(value * 1e5) / 1e5; }

/// Contours in the parameters of the surface, without the pixels that deviate by a pixel or less from a straight line.
Json outlines_json(const Frame& frame, const SurfaceModel& model, const std::vector<Contour>& contours) {
  Json outlines = Json::array();
  for (const Contour& contour : contours) {
    std::vector<cv::Point> line, corners;
    for (const int pixel : contour.pixels) line.emplace_back(pixel % frame.width(), pixel / frame.width());
    cv::approxPolyDP(line, corners, 1, true);
    Json vertices = Json::array();
    for (const cv::Point& corner : corners)
      if (const auto place = model.parameters(frame.point(corner.y * frame.width() + corner.x)); place)
        vertices.push_back({rounded(place->x()), rounded(place->y())});
    if (!vertices.empty()) outlines.push_back({{"hole", contour.hole}, {"vertices", std::move(vertices)}});
  }
  return outlines;
}

double rms_distance(const Frame& frame, const Surface& surface) {
  double sum = 0;
  for (const int pixel : surface.pixels) sum += double(surface.model->squared_distance(frame.point(pixel)));
  return std::sqrt(sum / double(surface.pixels.size()));
}

Json patches_json(const Scene& scene) {
  const Frame& frame = scene.frame();
  const SurfaceSet& surfaces = scene.surfaces();
  const std::vector<std::vector<Contour>>& contours = scene.contours();
  std::vector<Json> patches(surfaces.surfaces.size());
  tbb::parallel_for(std::size_t{0}, patches.size(), [&](std::size_t i) {
    const Surface& surface = surfaces.surfaces[i];
    patches[i] = {{"patch", i},
                  {"pixels", surface.pixels.size()},
                  {"surface", surface.model->to_json()},
                  {"rms", rms_distance(frame, surface)},
                  {"outlines", outlines_json(frame, *surface.model, contours[i])}};
    if (std::any_of(surface.refusals.begin(), surface.refusals.end(), [](const auto& r) { return !r.empty(); }))
      patches[i]["refusals"] = surface.refusals;
  });
  return patches;
}

/// The edges of the graph with the relation values that they come from.
Json pairs_json(const Percept& percept, const Graph& graph) {
  Json pairs = Json::array();
  for (const Edge& edge : graph.edges) {
    const std::vector<std::string>& names = percept.table(edge.level).names;
    const std::span<const double> row = percept.values(edge);
    Json values;
    for (std::size_t k = 0; k < names.size(); ++k) values[names[k]] = row[k];
    pairs.push_back({{"a", edge.a},
                     {"b", edge.b},
                     {"level", name_of(edge.level)},
                     {"p", edge.probability},
                     {"relations", std::move(values)}});
  }
  return pairs;
}

/// The original points with the label of the pixel that they are seen in, as a binary PCD file.
std::string point_labels(const Input& input, const cv::Mat_<std::uint16_t>& labels) {
  PointCloud cloud;
  cloud.width = int(input.cloud.size());
  cloud.height = 1;
  cloud.points = input.cloud;
  cloud.labels.reserve(input.point_pixels.size());
  for (const int pixel : input.point_pixels)
    cloud.labels.push_back(pixel < 0 ? std::uint16_t{0} : labels.ptr<std::uint16_t>()[pixel]);
  return encode_pcd(cloud);
}

/// From which another program, started elsewhere, finds the input again; "" of one made in memory.
std::string absolute_path(const std::filesystem::path& path) {
  std::error_code no_current_folder;
  const std::filesystem::path whole = std::filesystem::absolute(path, no_current_folder);
  return (path.empty() || no_current_folder ? path : whole.lexically_normal()).string();
}

Json noise_json(const DepthNoise& noise) {
  return {{"constant", noise.constant}, {"linear", noise.linear}, {"quadratic", noise.quadratic}};
}

}  // namespace

const std::set<std::string>& result_names() {
  static const std::set<std::string> names{
      "labels.png",         "objects.png",  "overlay.png", "patches.png", "labels.pcd",   "result.json",  "normals.png",
      "signal_patches.png", "surfaces.png", "lines.png",   "graph.png",   "labelled.pcd", "labelled.ply", "coco.json"};
  return names;
}

Json result_json(const Input& input, const SegmentedFrame& found, const Json& config) {
  const auto& [percept, segmentation, times] = found;
  Json patches;
  isolated([&] { patches = patches_json(*found.percept.scene); });
  Json result{{"format", "gestalt-result"},
              {"version", 2},
              {"gestalt", GESTALT_VERSION},
              {"build", build_fingerprint()},
              {"scene", input.frame.name},
              {"input", absolute_path(input.path)},
              {"camera", camera_json(input.frame.camera)},
              {"depth_noise", noise_json(percept.frame().noise)},
              {"depth_unit", input.depth_unit},
              {"warnings", input.warnings},
              {"notes", input.notes},
              {"segments", segments_json(segmentation)},
              {"objects", objects_json(found)},
              {"patches", std::move(patches)},
              {"pairs", pairs_json(percept, segmentation.graph)},
              {"milliseconds",
               {{"signal", times.signal},
                {"primitive", times.primitive},
                {"structural", times.structural},
                {"assembly", times.assembly},
                {"decision", times.decision},
                {"total", times.total()}}},
              {"config", config}};
  if (percept.left_out) result["left_out"] = name_of(*percept.left_out);
  if (percept.omitted_pairs > 0) result["omitted_pairs"] = percept.omitted_pairs;
  return result;
}

void write_result(const OutputPath& folder, const Input& input, const SegmentedFrame& found, const Json& config,
                  std::vector<OutputFile> more, const Json* tracks) {
  const Segmentation& segmentation = found.segmentation;
  std::vector<OutputFile> files{{folder / "labels.png", encode_png(segmentation.labels)},
                                {folder / "objects.png", encode_png(object_labels(segmentation))},
                                {folder / "overlay.png", encode_png(draw_segments(input.frame, segmentation))},
                                {folder / "patches.png", encode_png(draw_patches(found.percept.surfaces().labels))}};
  if (!input.cloud.empty()) files.push_back({folder / "labels.pcd", point_labels(input, segmentation.labels)});
  std::move(more.begin(), more.end(), std::back_inserter(files));
  Json result = result_json(input, found, config);
  if (tracks) result["tracks"] = *tracks;
  for (const auto& [file, bytes] : files) result["files"][file.path().filename().string()] = digest(bytes);
  // A scene's name comes from a path, which may be no UTF-8.
  const OutputPath last = folder / "result.json";
  const auto outdated = [&] {
    std::vector<std::string> names = own_files(last.path());
    std::erase_if(names, [](const std::string& name) { return !result_names().contains(name); });
    return names;
  };
  write_files(files, {last, result.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"}, outdated);
}

}  // namespace gestalt
