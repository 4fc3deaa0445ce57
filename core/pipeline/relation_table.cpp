// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/pipeline/relation_table.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <cmath>

#include "gestalt/core/base/error.h"
#include "gestalt/core/plugin/component_call.h"

namespace gestalt {

namespace {

// So many that a call costs little beside them, so few that all threads have some.
constexpr std::size_t pairs_at_once = 16;

void check_values(const NamedRelation& named, std::span<const double> values) {
  const std::vector<RelationValue>& declared = named.relation->values();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(values[i] >= declared[i].low && values[i] <= declared[i].high && std::isfinite(values[i])))
      throw PluginError("relation '" + named.name + "' returned " + declared[i].name + " = " +
                        std::to_string(values[i]) + ", outside its declared range [" + std::to_string(declared[i].low) +
                        ", " + std::to_string(declared[i].high) + "]; report this to its author");
}

/// A measure whose destructor runs as its relation's.
class OwnedMeasure final : public Measure {
 public:
  OwnedMeasure(ComponentName relation, std::unique_ptr<Measure> measure)
      : measure_(owned(relation, std::move(measure))) {}

  void operator()(const SurfacePair& pair, std::span<double> values) const override { (*measure_)(pair, values); }
  void measure(std::span<const SurfacePair> pairs, std::span<double> values) const override {
    measure_->measure(pairs, values);
  }

 private:
  std::shared_ptr<const Measure> measure_;
};

/// Indices of the values that a level has of a relation.
std::vector<std::size_t> kept(const NamedRelation& named) {
  const std::vector<RelationValue>& declared = named.relation->values();
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < declared.size(); ++i)
    if (named.values.empty() ||
        std::find(named.values.begin(), named.values.end(), declared[i].name) != named.values.end())
      indices.push_back(i);
  return indices;
}

}  // namespace

std::string value_name(const std::string& value, const std::string& relation, const std::string& plugin) {
  return relation == plugin ? value : value + "." + relation;
}

std::vector<std::string> value_names(const std::vector<NamedRelation>& relations) {
  std::vector<std::string> names;
  for (const NamedRelation& named : relations)
    for (const std::size_t i : kept(named)) {
      const std::string name = value_name(named.relation->values()[i].name, named.name, named.plugin);
      if (std::find(names.begin(), names.end(), name) != names.end())
        throw ConfigError("two relations of a level compute the value " + name + ", the second is '" + named.name +
                          "'; remove one of them");
      names.push_back(name);
    }
  return names;
}

bool large_enough(const SurfaceSet& surfaces, int surface, double minimum_size) {
  return double(surfaces.surfaces[std::size_t(surface)].pixels.size()) >= minimum_size;
}

std::vector<SurfacePair> neighbour_pairs(const SurfaceSet& surfaces, double minimum_size) {
  const auto large = [&](int surface) { return large_enough(surfaces, surface, minimum_size); };
  std::vector<SurfacePair> pairs;
  for (const Adjacency& adjacency : surfaces.adjacencies)
    if (!adjacency.border_3d.empty() && large(adjacency.a) && large(adjacency.b))
      pairs.push_back({adjacency.a, adjacency.b, &adjacency});
  return pairs;
}

namespace {

bool is_object(std::span<const Role> roles, std::size_t surface) {
  return roles.empty() || roles[surface] == Role::object;
}

std::vector<std::size_t> large_objects(const SurfaceSet& surfaces, double minimum_size, std::span<const Role> roles) {
  std::vector<std::size_t> large;
  for (std::size_t i = 0; i < surfaces.surfaces.size(); ++i)
    if (large_enough(surfaces, int(i), minimum_size) && is_object(roles, i)) large.push_back(i);
  return large;
}

std::size_t pairs_of(std::size_t count) { return count * (count - std::min<std::size_t>(count, 1)) / 2; }

using Pair = std::pair<std::size_t, std::size_t>;  // the lower number first

Pair ordered(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

std::vector<Pair> all_pairs(const std::vector<std::size_t>& of) {
  std::vector<Pair> pairs;
  pairs.reserve(of.size() * of.size() / 2);
  for (std::size_t i = 0; i < of.size(); ++i)
    for (std::size_t j = i + 1; j < of.size(); ++j) pairs.push_back(ordered(of[i], of[j]));
  return pairs;
}

cv::Point2d mean_pixel(const SurfaceSet& surfaces, std::size_t surface) {
  const int width = std::max(1, surfaces.labels.cols);
  cv::Point2d sum(0, 0);
  const std::vector<int>& pixels = surfaces.surfaces[surface].pixels;
  for (const int pixel : pixels) sum += cv::Point2d(pixel % width, pixel / width);
  return sum / double(pixels.size());
}

/// Each with so many that are nearest to it in the image, the first of equally near ones.
std::vector<Pair> nearest_pairs(const SurfaceSet& surfaces, const std::vector<std::size_t>& of, std::size_t count) {
  std::vector<cv::Point2d> centres;
  centres.reserve(of.size());
  for (const std::size_t surface : of) centres.push_back(mean_pixel(surfaces, surface));
  std::vector<Pair> pairs(of.size() * count);
  tbb::parallel_for(std::size_t{0}, of.size(), [&](std::size_t i) {
    std::vector<std::pair<double, std::size_t>> others;  // squared distance, index
    others.reserve(of.size());
    for (std::size_t j = 0; j < of.size(); ++j) {
      const cv::Point2d apart = centres[i] - centres[j];
      if (j != i) others.emplace_back(apart.dot(apart), j);
    }
    std::nth_element(others.begin(), others.begin() + std::ptrdiff_t(count), others.end());
    for (std::size_t k = 0; k < count; ++k) pairs[i * count + k] = ordered(of[i], of[others[k].second]);
  });
  return pairs;
}

/// The pairs of surfaces, or the bounded number of them, neighbours included; sorted.
std::vector<Pair> paired(const SurfaceSet& surfaces, std::vector<std::size_t> large) {
  if (pairs_of(large.size()) <= most_assembly_pairs) return all_pairs(large);
  std::stable_sort(large.begin(), large.end(), [&](std::size_t a, std::size_t b) {
    return surfaces.surfaces[a].pixels.size() > surfaces.surfaces[b].pixels.size();
  });
  if (large.size() > most_paired_surfaces) large.resize(most_paired_surfaces);
  const std::size_t half = most_assembly_pairs / 2;
  std::vector<Pair> pairs = nearest_pairs(surfaces, large, half / large.size());
  large.resize(std::size_t(std::sqrt(2 * double(half))));
  for (const Pair& pair : all_pairs(large)) pairs.push_back(pair);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace

std::vector<SurfacePair> non_neighbour_pairs(const SurfaceSet& surfaces, double minimum_size,
                                             std::span<const Role> roles) {
  std::vector<SurfacePair> pairs;
  auto adjacency = surfaces.adjacencies.begin();
  for (const auto& [first, second] : paired(surfaces, large_objects(surfaces, minimum_size, roles))) {
    const int a = int(first), b = int(second);
    while (adjacency != surfaces.adjacencies.end() && std::pair(adjacency->a, adjacency->b) < std::pair(a, b))
      ++adjacency;
    const bool touch = adjacency != surfaces.adjacencies.end() && adjacency->a == a && adjacency->b == b;
    if (!touch || adjacency->border_3d.empty()) pairs.push_back({a, b, touch ? &*adjacency : nullptr});
  }
  return pairs;
}

std::size_t omitted_pairs(const SurfaceSet& surfaces, double minimum_size, std::span<const Role> roles) {
  const std::size_t all = pairs_of(large_objects(surfaces, minimum_size, roles).size());
  if (all <= most_assembly_pairs) return 0;
  const std::vector<SurfacePair> neighbours = neighbour_pairs(surfaces, minimum_size);
  const auto of_objects = std::count_if(neighbours.begin(), neighbours.end(), [&](const SurfacePair& pair) {
    return is_object(roles, std::size_t(pair.a)) && is_object(roles, std::size_t(pair.b));
  });
  return all - std::size_t(of_objects) - non_neighbour_pairs(surfaces, minimum_size, roles).size();
}

Measures::Measures(const Scene& scene, const std::vector<NamedRelation>& relations)
    : deadline_(scene.frame().deadline) {
  std::map<const Relation*, ComponentName> names;
  for (const NamedRelation& named : relations) {
    measures_.try_emplace(named.relation.get());
    names.try_emplace(named.relation.get(), component_name("relation", named.name));
  }
  tbb::parallel_for_each(measures_, [&](auto& entry) {
    const ComponentName name = names.at(entry.first);
    std::unique_ptr<Measure> measure = call_component(name, [&] { return entry.first->bind(scene); });
    if (!measure) throw PluginError(std::string(name) + " returned no measure; report this to its author");
    entry.second = std::make_unique<OwnedMeasure>(name, std::move(measure));
    deadline_.require(name);
  });
}

RelationTable relate(const std::vector<SurfacePair>& pairs, const std::vector<NamedRelation>& relations,
                     const Measures& measures) {
  RelationTable table{value_names(relations), {}, {}};
  const std::size_t columns = table.names.size();
  table.values.resize(columns * pairs.size());
  for (const SurfacePair& pair : pairs) table.pairs.push_back({pair.a, pair.b});
  std::vector<std::vector<std::size_t>> kept_of;
  kept_of.reserve(relations.size());
  std::vector<ComponentName> names;
  names.reserve(relations.size());
  for (const NamedRelation& named : relations) {
    kept_of.push_back(kept(named));
    names.push_back(component_name("relation", named.name));
  }
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pairs.size(), pairs_at_once), [&](const auto& range) {
    const std::span<const SurfacePair> some(pairs.data() + range.begin(), range.size());
    std::size_t column = 0;
    std::vector<double> own;
    for (std::size_t r = 0; r < relations.size(); ++r) {
      const std::size_t width = relations[r].relation->values().size();
      own.assign(width * some.size(), 0);
      call_component(names[r], [&] { measures.of(*relations[r].relation).measure(some, own); });
      measures.deadline().require(names[r]);
      for (std::size_t i = 0; i < some.size(); ++i) {
        const std::span<const double> row(own.data() + i * width, width);
        check_values(relations[r], row);
        for (std::size_t k = 0; k < kept_of[r].size(); ++k)
          table.values[(range.begin() + i) * columns + column + k] = row[kept_of[r][k]];
      }
      column += kept_of[r].size();
    }
  });
  return table;
}

}  // namespace gestalt
