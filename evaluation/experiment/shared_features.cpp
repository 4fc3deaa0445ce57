// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "shared_features.h"

#include <algorithm>

namespace gestalt {

namespace {

bool equal(const ComponentConfig& a, const ComponentConfig& b) { return a.plugin == b.plugin && a.params == b.params; }

/// Index of the component in a list, where it is put when it is not there. Listed components are named "#<index>", so
/// that the names of their values, which end with that, tell them apart.
std::size_t place(const ComponentConfig& component, std::vector<ComponentConfig>& list) {
  const auto same = std::find_if(list.begin(), list.end(), [&](const auto& known) { return equal(known, component); });
  if (same != list.end()) return std::size_t(same - list.begin());
  list.push_back(component);
  list.back().name = "#" + std::to_string(list.size() - 1);
  list.back().values.clear();
  return list.size() - 1;
}

/// A column of a shared table, and what a variant calls it.
struct Column {
  std::size_t index;
  std::string name;
};

/// The columns of a shared table that hold the values that a variant has of a component.
void append_columns(const RelationTable& shared, const ComponentConfig& listed, const ComponentConfig& own,
                    std::vector<Column>& columns) {
  const std::string ending = "." + listed.name;
  for (std::size_t i = 0; i < shared.names.size(); ++i) {
    if (!shared.names[i].ends_with(ending)) continue;
    const std::string value = shared.names[i].substr(0, shared.names[i].size() - ending.size());
    if (!own.values.empty() && std::find(own.values.begin(), own.values.end(), value) == own.values.end()) continue;
    columns.push_back({i, value_name(value, own.name, own.plugin)});
  }
}

RelationTable select(const RelationTable& shared, const Percept& percept, const std::vector<ComponentConfig>& listed,
                     const LevelConfig& level) {
  std::vector<Column> columns;
  for (const ComponentConfig& own : level.relations) {
    const auto same = std::find_if(listed.begin(), listed.end(), [&](const auto& known) { return equal(known, own); });
    append_columns(shared, *same, own, columns);
  }

  RelationTable table;
  for (const Column& column : columns) table.names.push_back(column.name);
  const auto large_enough = [&](int surface) {
    return double(percept.surfaces.surfaces[std::size_t(surface)].pixels.size()) >=
           level.minimum_size * percept.pixel_density;
  };
  for (std::size_t i = 0; i < shared.pairs.size(); ++i) {
    if (!large_enough(shared.pairs[i].a) || !large_enough(shared.pairs[i].b)) continue;
    table.pairs.push_back(shared.pairs[i]);
    const std::span<const double> row = shared.row(i);
    for (const Column& column : columns) table.values.push_back(row[column.index]);
  }
  return table;
}

}  // namespace

SharedFeatures::SharedFeatures(const std::vector<const Variant*>& variants, const Registry& registry) {
  Config config = variants.front()->config;
  config.with_assembly = false;
  config.assembly.reset();
  for (const Variant* variant : variants) {
    const Config& own = variant->config;
    for (const ComponentConfig& relation : own.structural.relations) place(relation, structural_);
    config.structural.minimum_size = std::min(config.structural.minimum_size, own.structural.minimum_size);
    if (!own.with_assembly) continue;
    for (const ComponentConfig& relation : own.assembly->relations) place(relation, assembly_);
    const int smallest = config.with_assembly ? config.assembly->minimum_size : own.assembly->minimum_size;
    config.with_assembly = true;
    if (!config.assembly) config.assembly = own.assembly;
    config.assembly->minimum_size = std::min(smallest, own.assembly->minimum_size);
  }
  config.structural.relations = structural_;
  if (config.assembly) config.assembly->relations = assembly_;
  pipeline_ = std::make_unique<const Pipeline>(std::move(config), registry);
}

LearningScene SharedFeatures::perceive(const Frame& frame, const cv::Mat_<std::uint16_t>& ground_truth) const {
  return make_learning_scene(*pipeline_, frame, ground_truth);
}

LearningScene SharedFeatures::scene_for(const Variant& variant, const LearningScene& shared) const {
  LearningScene scene = shared;
  const Config& config = variant.config;
  scene.percept.structural = select(shared.percept.structural, shared.percept, structural_, config.structural);
  scene.percept.assembly = config.with_assembly
                               ? select(shared.percept.assembly, shared.percept, assembly_, *config.assembly)
                               : RelationTable{};
  return scene;
}

}  // namespace gestalt
