// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "shared_features.h"

#include <algorithm>

namespace gestalt {

namespace {

bool equal(const ComponentConfig& a, const ComponentConfig& b) { return a.plugin == b.plugin && a.params == b.params; }

/// Whether a variant's relation has a value, as ComponentConfig::values says.
bool has_value(const ComponentConfig& own, const std::string& value) {
  return own.values.empty() || std::find(own.values.begin(), own.values.end(), value) != own.values.end();
}

}  // namespace

void SharedRelations::add(const ComponentConfig& relation, const Registry& registry) {
  const auto known = [&](const ComponentConfig& other) { return equal(other, relation); };
  if (std::any_of(components.begin(), components.end(), known)) return;
  const std::size_t component = components.size();
  components.push_back(relation);
  components.back().name = "#" + std::to_string(component);  // a config needs names that differ
  components.back().values.clear();
  for (const RelationValue& value : registry.create<Relation>(relation.plugin, relation.params)->values())
    columns.push_back({component, value.name});
}

RelationTable SharedRelations::select(const RelationTable& shared, const Percept& percept,
                                      const LevelConfig& level) const {
  RelationTable table;
  std::vector<std::size_t> chosen;  // of the shared columns
  for (const ComponentConfig& own : level.relations)
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (!equal(components[columns[i].component], own) || !has_value(own, columns[i].value)) continue;
      chosen.push_back(i);
      table.names.push_back(value_name(columns[i].value, own.name, own.plugin));
    }
  const double minimum_size = level.minimum_size * percept.pixel_density;
  for (std::size_t i = 0; i < shared.pairs.size(); ++i) {
    const auto [a, b] = shared.pairs[i];
    if (!large_enough(percept.surfaces(), a, minimum_size) || !large_enough(percept.surfaces(), b, minimum_size))
      continue;
    table.pairs.push_back(shared.pairs[i]);
    const std::span<const double> row = shared.row(i);
    for (const std::size_t column : chosen) table.values.push_back(row[column]);
  }
  return table;
}

SharedFeatures::SharedFeatures(const std::vector<const Variant*>& variants, const Registry& registry) {
  Config config = variants.front()->config;
  config.with_assembly = false;
  config.assembly.reset();
  for (const Variant* variant : variants) {
    const Config& own = variant->config;
    for (const ComponentConfig& relation : own.structural.relations) structural_.add(relation, registry);
    config.structural.minimum_size = std::min(config.structural.minimum_size, own.structural.minimum_size);
    if (!own.with_assembly) continue;
    for (const ComponentConfig& relation : own.assembly->relations) assembly_.add(relation, registry);
    const int smallest = config.with_assembly ? config.assembly->minimum_size : own.assembly->minimum_size;
    config.with_assembly = true;
    if (!config.assembly) config.assembly = own.assembly;
    config.assembly->minimum_size = std::min(smallest, own.assembly->minimum_size);
  }
  config.structural.relations = structural_.components;
  if (config.assembly) config.assembly->relations = assembly_.components;
  pipeline_ = std::make_unique<const Pipeline>(std::move(config), registry);
}

LearningScene SharedFeatures::perceive(const Frame& frame, const cv::Mat_<std::uint16_t>& ground_truth) const {
  return make_learning_scene(*pipeline_, frame, ground_truth);
}

LearningScene SharedFeatures::scene_for(const Variant& variant, const LearningScene& shared) const {
  LearningScene scene = shared;
  const Config& config = variant.config;
  scene.percept.structural = structural_.select(shared.percept.structural, shared.percept, config.structural);
  scene.percept.assembly = config.with_assembly
                               ? assembly_.select(shared.percept.assembly, shared.percept, *config.assembly)
                               : RelationTable{};
  return scene;
}

}  // namespace gestalt
