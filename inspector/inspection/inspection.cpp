// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/inspector/inspection/inspection.h"

#include <algorithm>
#include <cmath>

#include "contributions.h"
#include "cuts.h"
#include "difference.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/for_all.h"
#include "gestalt/core/pipeline/learning_set.h"
#include "gestalt/core/scene/scene.h"
#include "gestalt/io/result/parametric_surface.h"
#include "gestalt/io/result/result.h"
#include "gestalt/io/result/result_file.h"
#include "gestalt/io/result/segment_colours.h"
#include "scene_images.h"

namespace gestalt {

using nlohmann::json;

namespace {

constexpr std::size_t most_assembly_edges = 4000;   // of a scene; their number grows with the square of the patches
constexpr double mesh_tolerance = 0.001;            // m
constexpr double mesh_unit = 0.0001;                // m
constexpr std::size_t most_mesh_triangles = 20000;  // of one patch

/// To so many decimals.
double rounded(double value, int decimals) {
  const double unit = std::pow(10.0, decimals);
  return std::round(value * unit) / unit + 0.0;  // no -0
}

/// To four digits.
double brief(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  return rounded(value, std::clamp(3 - int(std::floor(std::log10(std::abs(value)))), 0, 12));
}

/// JSON has no infinity.
json bound(double value) { return std::isfinite(value) ? json(value) : json(); }

/// 1 or 0: ground truth has both patches in one object, or not; null where training would not take the pair either.
json truth_of(const std::vector<int>& objects, int a, int b) {
  if (objects.empty()) return nullptr;
  const int of_a = objects[std::size_t(a)], of_b = objects[std::size_t(b)];
  if (of_a == 0 || of_b == 0 || (of_a == 1 && of_b == 1)) return nullptr;
  return int(of_a == of_b);
}

/// The fitted surface as triangles, flat lists of coordinates in mesh_unit and of indices; null for a surface that
/// cannot be drawn.
json mesh_of(const json& patch) {
  Mesh mesh;
  TriangulationBudget budget;
  try {
    mesh = triangulate(read_surface(patch), mesh_tolerance, budget);
  } catch (const ModelError&) {
    return nullptr;  // a fitter of one's own
  } catch (const InputError&) {
    return nullptr;  // outlines too tangled for triangles
  }
  if (mesh.triangles.size() > most_mesh_triangles) return nullptr;
  json vertices = json::array(), triangles = json::array();
  for (const Eigen::Vector3d& p : mesh.vertices)
    for (const double x : {p.x(), p.y(), p.z()}) vertices.push_back(std::lround(x / mesh_unit));
  for (const auto& triangle : mesh.triangles)
    for (const int vertex : triangle) triangles.push_back(vertex);
  return {{"vertices", std::move(vertices)}, {"triangles", std::move(triangles)}};
}

/// The pixel of a patch that is nearest to the middle of all of them: unlike the middle, it lies on the patch.
cv::Point anchor_of(const Surface& surface, int width) {
  double u = 0, v = 0;
  for (const int pixel : surface.pixels) u += pixel % width, v += pixel / width;
  u /= double(surface.pixels.size()), v /= double(surface.pixels.size());
  const auto distance = [&](int pixel) { return std::hypot(pixel % width - u, pixel / width - v); };
  const int nearest = *std::min_element(surface.pixels.begin(), surface.pixels.end(),
                                        [&](int a, int b) { return distance(a) < distance(b); });
  return {nearest % width, nearest / width};
}

json patches_of(const json& result, const Input& input, const Percept& percept, const std::vector<int>& objects) {
  std::vector<json> patches(percept.surfaces().surfaces.size());
  for_all(patches.size(), [&](std::size_t i) {
    const json& told = result.at("patches")[i];
    const cv::Point anchor = anchor_of(percept.surfaces().surfaces[i], input.frame.width());
    patches[i] = {{"pixels", told.at("pixels")},
                  {"type", percept.surfaces().surfaces[i].model->type()},
                  {"rms", brief(told.at("rms").get<double>())},
                  {"role", name_of(percept.roles[i])},
                  {"object", objects.empty() ? json() : json(objects[i])},
                  {"anchor", {anchor.x, anchor.y}},
                  {"mesh", mesh_of(told)}};
  });
  return patches;
}

/// What each level's relation values are called and mean, and the range of each in training.
json level_of(Level level, const LevelConfig& config, const Registry& registry, const Model& model) {
  std::vector<RelationValue> declared;
  std::vector<std::string> relations;
  for (const ComponentConfig& component : config.relations) {
    const auto relation = registry.create<Relation>(component.plugin, component.params);
    for (const RelationValue& value : relation->values()) {
      const auto& chosen = component.values;
      if (!chosen.empty() && std::find(chosen.begin(), chosen.end(), value.name) == chosen.end()) continue;
      declared.push_back(value);
      relations.push_back(component.name);
    }
  }
  json values = json::array();
  for (std::size_t i = 0; i < model.names.size(); ++i)
    values.push_back({{"name", model.names[i]},
                      {"relation", relations.at(i)},
                      {"text", declared.at(i).text},
                      {"range", {bound(declared[i].low), bound(declared[i].high)}},
                      {"trained", {brief(model.scaling.low[i]), brief(model.scaling.high[i])}}});
  return {{"name", name_of(level)}, {"classifier", config.classifier.plugin}, {"values", std::move(values)}};
}

/// Indices of the edges to show, ascending: all of the structural level, and of the assembly level those that are
/// farthest from the truth, or, without ground truth, nearest to p = 1/2; ties by number.
std::vector<std::size_t> shown_edges(const Graph& graph, const std::vector<int>& objects) {
  std::vector<std::size_t> shown, assembly;
  for (std::size_t i = 0; i < graph.edges.size(); ++i)
    (graph.edges[i].level == Level::structural ? shown : assembly).push_back(i);
  if (assembly.size() > most_assembly_edges) {
    const auto interest = [&](std::size_t i) {
      const Edge& edge = graph.edges[i];
      const json truth = truth_of(objects, edge.a, edge.b);
      return truth.is_null() ? 0.5 - std::abs(edge.probability - 0.5) : std::abs(edge.probability - truth.get<int>());
    };
    std::stable_sort(assembly.begin(), assembly.end(),
                     [&](std::size_t a, std::size_t b) { return interest(a) > interest(b); });
    assembly.resize(most_assembly_edges);
  }
  shown.insert(shown.end(), assembly.begin(), assembly.end());
  std::sort(shown.begin(), shown.end());
  return shown;
}

/// [a, b, level, p, truth, values, contributions] of each edge shown.
json edges_of(const Graph& graph, const std::vector<std::size_t>& shown, const Percept& percept, const Models& models,
              const std::vector<int>& objects) {
  std::vector<json> edges(shown.size());
  for_all(shown.size(), [&](std::size_t i) {
    const Edge& edge = graph.edges[shown[i]];
    const bool structural = edge.level == Level::structural;
    const std::span<const double> values = percept.values(edge);
    json told = json::array(), contributed = json::array();
    for (const double value : values) told.push_back(brief(value));
    for (const double part : contributions(structural ? models.structural : *models.assembly, values))
      contributed.push_back(rounded(part, 3));
    edges[i] = {edge.a,
                edge.b,
                structural ? 0 : 1,
                rounded(edge.probability, 4),
                truth_of(objects, edge.a, edge.b),
                std::move(told),
                std::move(contributed)};
  });
  return edges;
}

json point(const Eigen::Vector2f& p) { return {rounded(p.x(), 1), rounded(p.y(), 1)}; }

/// Boundary lines [surface, what is beyond, first end, second end]; links [kind, where they meet, end, end]; closures.
void add_lines(json& content, const Scene& scene) {
  static const char* const beyond[] = {"farther", "level", "nothing", "nearer", "image edge"};  // in order of Beyond
  const BoundaryLines& found = scene.boundary_lines();
  json lines = json::array(), closures = json::array();
  for (const BoundaryLine& line : found.lines)
    lines.push_back({line.surface, beyond[std::size_t(line.beyond)], point(line.ends[0]), point(line.ends[1])});
  for (const Closure& closure : scene.closures()) {
    json outline = json::array(), patches = json::array();
    for (const Eigen::Vector2f& corner : closure.outline) outline.push_back(point(corner));
    for (const Closure::Part& part : closure.parts) patches.push_back(part.surface);
    closures.push_back({{"outline", outline},
                        {"patches", patches},
                        {"cost", brief(closure.cost)},
                        {"lines", rounded(closure.line_length, 1)},
                        {"gaps", rounded(closure.gap_length, 1)}});
  }
  content["lines"] = std::move(lines);
  content["closures"] = std::move(closures);
}

/// The colours of overlay.png, by label - 1, [red, green, blue]; null for background.
json colours_of(const Segmentation& segmentation) {
  const std::vector<cv::Vec3b> colours = segment_colours(segmentation);
  json told = json::array();
  for (std::size_t i = 0; i < colours.size(); ++i)
    told.push_back(segmentation.segments[i].role == Role::object ? json{colours[i][2], colours[i][1], colours[i][0]}
                                                                 : json());
  return told;
}

json solver_of(const Config& config, const Cuts& cuts) {
  json told = json::array(), sweeps = json::array();
  for (const Cut& cut : cuts.cuts) {
    json background = json::array();
    for (std::size_t i = 0; i < cut.roles.size(); ++i)
      if (cut.roles[i] == Role::background) background.push_back(i + 1);
    told.push_back({{"labels", cut.labels}, {"background", std::move(background)}});
  }
  for (const Sweep& sweep : cuts.sweeps)
    sweeps.push_back({{"name", sweep.parameter.name},
                      {"text", sweep.parameter.text},
                      {"unit", sweep.parameter.unit},
                      {"current", sweep.current},
                      {"values", sweep.values},
                      {"cuts", sweep.cuts}});
  return {{"plugin", config.solver.plugin}, {"cuts", std::move(told)}, {"sweeps", std::move(sweeps)}};
}

/// Says in one sentence where the stored result and the one computed now differ.
json notes_of(const json& stored, const json& result) {
  for (const char* part : {"scene", "camera", "patches", "pairs", "segments"}) {
    if (!stored.contains(part)) return {"The result.json lacks \"" + std::string(part) + "\"."};
    if (const std::string place = first_difference(stored[part], result[part], part); !place.empty())
      return {"This page shows the scene as it is segmented now, which differs from the result.json, first at " +
              place + "; the input, the model or the program may have changed since."};
  }
  return json::array();
}

}  // namespace

json inspect_scene(const json& stored, const Input& input, const Segmenter& segmenter) {
  const Config& config = segmenter.config();
  const Registry& registry = segmenter.registry();
  const Models& models = segmenter.models();
  const SegmentedFrame found = segmenter.segment(input.frame);
  const Percept& percept = found.percept;
  const Segmentation& segmentation = found.segmentation;
  const json result = result_json(input, found, {});
  const std::vector<int> objects =
      input.ground_truth.empty() ? std::vector<int>{} : surface_objects(percept.surfaces(), input.ground_truth);
  const std::vector<std::size_t> shown = shown_edges(segmentation.graph, objects);

  json levels = json::array({level_of(Level::structural, config.structural, registry, models.structural)});
  if (models.assembly) levels.push_back(level_of(Level::assembly, *config.assembly, registry, *models.assembly));
  json content{{"format", "gestalt-inspection"},
               {"version", 1},
               {"name", input.frame.name},
               {"gestalt", result.at("gestalt")},
               {"camera", result.at("camera")},
               {"notes", notes_of(stored, result)},
               {"images", scene_images(input, percept)},
               {"patches", patches_of(result, input, percept, objects)},
               {"mesh_unit", mesh_unit},
               {"levels", std::move(levels)},
               {"edges", edges_of(segmentation.graph, shown, percept, models, objects)},
               {"colours", colours_of(segmentation)},
               {"edges_left_out", segmentation.graph.edges.size() - shown.size()},
               {"solver", solver_of(config, sweep_solver(config, registry, percept, models))}};
  add_lines(content, *percept.scene);
  return content;
}

}  // namespace gestalt
