// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/relation_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "gestalt/error.h"

namespace gestalt {

namespace {

void check_values(const NamedRelation& named, std::span<const double> values) {
  const std::vector<RelationValue>& declared = named.relation->values();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(values[i] >= declared[i].low && values[i] <= declared[i].high && std::isfinite(values[i])))
      throw PluginError("relation '" + named.name + "' gave " + declared[i].name + " = " + std::to_string(values[i]) +
                        ", outside its declared range [" + std::to_string(declared[i].low) + ", " +
                        std::to_string(declared[i].high) + "]; report this to its author");
}

}  // namespace

std::vector<std::string> value_names(const std::vector<NamedRelation>& relations) {
  std::vector<std::string> names;
  for (const NamedRelation& named : relations)
    for (const RelationValue& value : named.relation->values()) {
      const std::string name = named.name == named.plugin ? value.name : value.name + "." + named.name;
      if (std::find(names.begin(), names.end(), name) != names.end())
        throw ConfigError("structural.relations: two relations give the value " + name + ", the second is '" +
                          named.name + "'; take one of them out");
      names.push_back(name);
    }
  return names;
}

RelationTable relate_neighbours(const Scene& scene, const std::vector<NamedRelation>& relations, int minimum_size) {
  RelationTable table{value_names(relations), {}, {}};
  std::vector<const Adjacency*> borders;
  const auto large_enough = [&](int i) {
    return int(scene.surfaces().surfaces[std::size_t(i)].pixels.size()) >= minimum_size;
  };
  for (const Adjacency& adjacency : scene.surfaces().adjacencies) {
    if (adjacency.border_3d.empty() || !large_enough(adjacency.a) || !large_enough(adjacency.b)) continue;
    table.pairs.push_back({adjacency.a, adjacency.b});
    borders.push_back(&adjacency);
  }
  const std::size_t columns = table.names.size();
  table.values.resize(columns * table.pairs.size());
  if (table.pairs.empty()) return table;

  std::vector<std::unique_ptr<Measure>> measures(relations.size());
  tbb::parallel_for(std::size_t{0}, relations.size(),
                    [&](std::size_t r) { measures[r] = relations[r].relation->bind(scene); });

  tbb::parallel_for(std::size_t{0}, table.pairs.size(), [&](std::size_t i) {
    const SurfacePair pair{table.pairs[i].a, table.pairs[i].b, borders[i]};
    std::span<double> row(table.values.data() + i * columns, columns);
    for (std::size_t r = 0; r < relations.size(); ++r) {
      const std::span<double> own = row.first(relations[r].relation->values().size());
      (*measures[r])(pair, own);
      check_values(relations[r], own);
      row = row.subspan(own.size());
    }
  });
  return table;
}

}  // namespace gestalt
