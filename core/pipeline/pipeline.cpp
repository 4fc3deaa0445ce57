// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/pipeline/pipeline.h"

#include <tbb/parallel_for_each.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <numeric>

#include "aside.h"
#include "checked_fitter.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/isolated.h"
#include "gestalt/core/config/sensor_params.h"
#include "gestalt/core/plugin/component_call.h"
#include "gestalt/core/plugin/contract.h"
#include "gestalt/core/scene/images.h"
#include "working_resolution.h"

namespace gestalt {

namespace {

// Each takes about 120 bytes and a microsecond: 2 GB, 17 s. Depth cameras have at most some 5 million.
constexpr std::size_t most_pixels = std::size_t{1} << 24;

/// Adds the time of its life to a sum.
class Stopwatch {
 public:
  explicit Stopwatch(double& milliseconds) : milliseconds_(milliseconds) {}
  ~Stopwatch() {
    milliseconds_ += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& milliseconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Puts the pairs of some rows of a table into the graph.
void add_edges(Graph& graph, const RelationTable& table, const std::vector<std::size_t>& rows, const Model& model,
               Level level, const Deadline& deadline) {
  std::vector<double> values;
  values.reserve(rows.size() * table.names.size());
  for (const std::size_t row : rows) values.insert(values.end(), table.row(row).begin(), table.row(row).end());
  const ComponentName classifier = component_name("classifier", model.classifier);
  const std::vector<double> p = call_component(classifier, [&] { return model.probabilities(values); });
  deadline.require(classifier);
  require_probabilities(classifier, p);
  for (std::size_t i = 0; i < rows.size(); ++i)
    graph.edges.push_back({table.pairs[rows[i]].a, table.pairs[rows[i]].b, p[i], level, rows[i]});
}

std::vector<int> each_alone(const Percept& percept) {
  std::vector<int> groups(percept.surfaces().surfaces.size());
  std::iota(groups.begin(), groups.end(), 0);
  return groups;
}

std::vector<int> cut(const Solver& solver, const std::string& plugin, const Graph& graph, const Deadline& deadline) {
  const ComponentName name = component_name("solver", plugin);
  std::vector<int> groups = call_component(name, [&] { return solver.solve(graph); });
  deadline.require(name);
  require_groups(name, groups, graph.sizes.size());
  return groups;
}

/// "fitter 'plane', 'bspline'": all of them, as they take turns.
ComponentName name_of_fitters(const std::vector<ComponentConfig>& fitters) {
  std::string names;
  for (const ComponentConfig& fitter : fitters) names += (names.empty() ? "" : "', '") + fitter.plugin;
  return component_name("fitter", names);
}

/// The same of relations, whose observations are destroyed in no order.
ComponentName name_of_observers(const std::vector<NamedRelation>& relations) {
  std::string names;
  for (const NamedRelation& named : relations) names += (names.empty() ? "" : "', '") + named.name;
  return component_name("relation", names);
}

/// Groups of surfaces as segments, largest first; equal sizes in order of their first surface.
Segmentation assemble(const Percept& percept, Graph graph, const std::vector<int>& groups) {
  const SurfaceSet& surfaces = percept.surfaces();
  const int count = groups.empty() ? 0 : 1 + *std::max_element(groups.begin(), groups.end());
  std::vector<Segment> segments{std::size_t(count)};
  std::vector<int> background_pixels(segments.size(), 0);
  std::vector<double> sizes(segments.size(), 0);
  for (std::size_t s = 0; s < groups.size(); ++s) {
    Segment& segment = segments[std::size_t(groups[s])];
    segment.surfaces.push_back(int(s));
    const int pixels = int(surfaces.surfaces[s].pixels.size());
    segment.pixel_count += pixels;
    if (percept.roles[s] == Role::background) background_pixels[std::size_t(groups[s])] += pixels;
    sizes[std::size_t(groups[s])] += percept.sizes[s];
  }
  for (std::size_t i = 0; i < segments.size(); ++i)
    segments[i].role =
        2 * background_pixels[i] > segments[i].pixel_count || sizes[i] < 1 ? Role::background : Role::object;
  std::stable_sort(segments.begin(), segments.end(),
                   [](const Segment& x, const Segment& y) { return x.pixel_count > y.pixel_count; });
  if (segments.size() > std::numeric_limits<std::uint16_t>::max())
    throw Error("the frame falls into " + std::to_string(segments.size()) +
                " segments, but a 16-bit label image holds at most 65535; choose clusterer parameters that make larger "
                "patches");

  Segmentation result{cv::Mat_<std::uint16_t>(surfaces.labels.size(), std::uint16_t{0}), std::move(segments),
                      std::move(graph)};
  for (std::size_t i = 0; i < result.segments.size(); ++i)
    for (const int s : result.segments[i].surfaces)
      for (const int pixel : surfaces.surfaces[std::size_t(s)].pixels)
        result.labels.ptr<std::uint16_t>()[pixel] = std::uint16_t(i + 1);
  return result;
}

}  // namespace

Pipeline::Pipeline(Config config, const Registry& registry)
    : config_(std::move(config)),
      clusterer_(registry.create<Clusterer>(config_.clusterer.plugin, config_.clusterer.params)),
      surface_modelling_(SurfaceModellingParams::parameters().read(config_.surface_modelling)),
      sensor_(SensorParams::parameters().read(config_.sensor)),
      solver_(registry.create<Solver>(config_.solver.plugin, config_.solver.params)),
      figure_ground_(FigureGroundParams::parameters().read(config_.figure_ground)) {
  for (const ComponentConfig& fitter : config_.fitters)
    fitters_.push_back(checked_fitter(registry.create<Fitter>(fitter.plugin, fitter.params), fitter.plugin));
  Known known;
  structural_ = make_grouping(config_.structural, registry, known);
  if (config_.with_assembly) assembly_ = make_grouping(config_.assembly.value(), registry, known);
  for (auto& [component, relation] : known) relations_.push_back(std::move(relation));
}

/// Equal relations of two levels are one object, so that they are bound to a scene once.
Pipeline::Grouping Pipeline::make_grouping(const LevelConfig& config, const Registry& registry, Known& known) {
  Grouping grouping;
  for (const ComponentConfig& component : config.relations) {
    const auto same = std::find_if(known.begin(), known.end(), [&](const auto& entry) {
      return entry.first.plugin == component.plugin && entry.first.params == component.params;
    });
    NamedRelation named{component.name, nullptr, component.plugin, component.values};
    if (same != known.end()) {
      named.relation = same->second.relation;
    } else {
      named.relation = registry.create<Relation>(component.plugin, component.params);
      known.emplace_back(component, named);
    }
    grouping.relations.push_back(std::move(named));
  }
  grouping.classifier = registry.create<Classifier>(config.classifier.plugin, config.classifier.params);
  grouping.value_names = gestalt::value_names(grouping.relations);
  grouping.minimum_size = config.minimum_size;
  return grouping;
}

ExpectedModel Pipeline::expected_model(Level level) const {
  if (level == Level::structural)
    return {*structural_.classifier, config_.structural.classifier.plugin, structural_.value_names};
  if (!assembly_) throw ConfigError("the config has no assembly level; set levels to structural+assembly");
  return {*assembly_->classifier, config_.assembly->classifier.plugin, assembly_->value_names};
}

Models Pipeline::load_models() const {
  if (config_.model.empty())
    throw ModelError("the config names no model (model:); train one with 'gestalt train SCENES --output MODEL'");
  return read_models(config_.model, expected_model(Level::structural),
                     assembly_ ? std::optional(expected_model(Level::assembly)) : std::nullopt);
}

bool Pipeline::trained_otherwise(const Models& models) const {
  const auto otherwise = [&](Level level, const Model& model) {
    return model.config_hash != gestalt::config_hash(config_, level);
  };
  return otherwise(Level::structural, models.structural) ||
         (models.assembly && otherwise(Level::assembly, *models.assembly));
}

Percept Pipeline::perceive(const Frame& frame) const {
  Percept percept;
  isolated([&] { percept = perceive_uncancelled(frame); });
  return percept;
}

/// Does the work of a level; one that the time does not suffice for is left out where late frames are coarse.
template <class Work>
void Pipeline::unless_late(Percept& percept, Level level, const Work& work) const {
  try {
    work();
  } catch (const TimeError&) {
    if (!config_.coarse_when_late) throw;
    percept.left_out = level;
  }
}

Percept Pipeline::perceive_uncancelled(const Frame& given) const {
  if (given.depth.total() > most_pixels)
    throw InputError(given.name + ": has " + std::to_string(given.width()) + "x" + std::to_string(given.height()) +
                     " pixels, more than the limit of 2^24; crop or downscale its images, for example to 4096x4096 " +
                     "pixels, and give the camera that matches them");
  if (!given.has_colour())
    for (const NamedRelation& named : relations_)
      if (named.relation->needs_colour())
        throw InputError(
            given.name + ": has no colour image, and relation '" + named.name +
            "' needs one; add rgb.png, or use a config without colour relations and a model trained for it");
  Percept percept;
  const int factor = reduction(given.depth.size(), config_.working_resolution);
  Frame frame = given;  // shares the images
  frame.deadline = Deadline::within(config_.time_budget, 0);
  if (factor > 1) {
    const Stopwatch watch(percept.times.signal);
    frame = reduced(frame, factor);
  }
  frame.noise = sensor_.depth_noise(frame);
  const auto images = std::make_shared<Images>(frame);
  Aside observations([&] {
    tbb::parallel_for_each(relations_, [&](const NamedRelation& named) {
      const ComponentName name = component_name("relation", named.name);
      call_component(name, [&] { images->observation(*named.relation); });
      frame.deadline.require(name);
    });
  });
  PatchMap patches;
  {
    const Stopwatch watch(percept.times.signal);
    const ComponentName name = component_name("clusterer", config_.clusterer.plugin);
    patches = call_component(name, [&] { return clusterer_->cluster(frame); });
    frame.deadline.require(name);
    require_patches(name, patches, frame);
  }
  {
    const Stopwatch watch(percept.times.primitive);
    const ComponentName name = name_of_fitters(config_.fitters);
    SurfaceSet surfaces =
        call_component(name, [&] { return model_surfaces(frame, patches, fitters_, surface_modelling_); });
    frame.deadline.require(name);
    percept.scene = std::make_shared<const Scene>(images, std::move(patches), std::move(surfaces));
  }
  percept.pixel_density = pixel_density(frame.camera);
  percept.separate = figure_ground_.separate;
  percept.structural.names = structural_.value_names;
  std::optional<Measures> measures;
  {
    // Relations ask for no roles, so that neither waits for the other.
    const Stopwatch watch(percept.times.structural);
    tbb::parallel_invoke(
        [&] {
          percept.roles = find_roles(frame, percept.surfaces(), figure_ground_);
          percept.sizes = find_sizes(frame, percept.surfaces(), figure_ground_);
          if (!config_.coarse_when_late) frame.deadline.require("the separation of figure and ground");
        },
        [&] {
          unless_late(percept, Level::structural, [&] {
            observations.wait();
            measures.emplace(*percept.scene, relations_);
            percept.structural =
                relate(neighbour_pairs(percept.surfaces(), structural_.minimum_size * percept.pixel_density),
                       structural_.relations, *measures);
          });
        });
  }
  if (assembly_) percept.assembly.names = assembly_->value_names;
  if (assembly_ && !percept.left_out)
    unless_late(percept, Level::assembly, [&] {
      const Stopwatch watch(percept.times.assembly);
      const double minimum_size = assembly_->minimum_size * percept.pixel_density;
      const std::span<const Role> roles =
          percept.separate ? std::span<const Role>(percept.roles) : std::span<const Role>();
      percept.assembly =
          relate(non_neighbour_pairs(percept.surfaces(), minimum_size, roles), assembly_->relations, *measures);
      percept.omitted_pairs = gestalt::omitted_pairs(percept.surfaces(), minimum_size, roles);
    });
  measures.reset();
  call_component(name_of_observers(relations_), [&] { images->forget_observations(); });
  if (factor > 1) {
    const Stopwatch watch(percept.times.signal);
    percept.scene = enlarged(*percept.scene, given, factor, surface_modelling_);
    percept.pixel_density = pixel_density(given.camera);
  }
  return percept;
}

Graph Pipeline::structural_graph(const Percept& percept, const Model& model, const Deadline& deadline) const {
  Graph graph;
  for (const Surface& surface : percept.surfaces().surfaces) graph.sizes.push_back(int(surface.pixels.size()));
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < percept.structural.pairs.size(); ++i) {
    const auto [a, b] = percept.structural.pairs[i];
    if (!percept.separate || percept.roles[std::size_t(a)] == percept.roles[std::size_t(b)]) rows.push_back(i);
  }
  add_edges(graph, percept.structural, rows, model, Level::structural, deadline);
  return graph;
}

std::vector<std::size_t> assembly_rows(const Percept& percept, const std::vector<int>& structural_groups) {
  const auto may_group = [&](int surface) {
    return !percept.separate || percept.roles[std::size_t(surface)] == Role::object;
  };
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < percept.assembly.pairs.size(); ++i) {
    const auto [a, b] = percept.assembly.pairs[i];
    if (structural_groups[std::size_t(a)] != structural_groups[std::size_t(b)] && may_group(a) && may_group(b))
      rows.push_back(i);
  }
  return rows;
}

std::vector<int> Pipeline::structural_groups(const Percept& percept, const Model& model) const {
  if (solver_->takes_all_pairs()) return each_alone(percept);
  return cut(*solver_, config_.solver.plugin, structural_graph(percept, model, {}), {});
}

Segmentation Pipeline::decide(const Percept& percept, const Models& models, LevelTimes* times) const {
  LevelTimes ignored;
  LevelTimes& spent = times ? *times : ignored;
  const Deadline deadline =
      config_.coarse_when_late ? Deadline() : Deadline::within(config_.time_budget, percept.times.total());
  Graph graph;
  {
    const Stopwatch watch(spent.structural);
    graph = structural_graph(percept, models.structural, deadline);
  }
  std::vector<int> groups = each_alone(percept);
  if (!assembly_ || !solver_->takes_all_pairs()) {
    const Stopwatch watch(spent.decision);
    groups = cut(*solver_, config_.solver.plugin, graph, deadline);
  }
  if (assembly_) {
    {
      const Stopwatch watch(spent.assembly);
      add_edges(graph, percept.assembly, assembly_rows(percept, groups), *models.assembly, Level::assembly, deadline);
      std::sort(graph.edges.begin(), graph.edges.end(),
                [](const Edge& x, const Edge& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });
    }
    const Stopwatch watch(spent.decision);
    groups = cut(*solver_, config_.solver.plugin, graph, deadline);
  }
  return assemble(percept, std::move(graph), groups);
}

}  // namespace gestalt
