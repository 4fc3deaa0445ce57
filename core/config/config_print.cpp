// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "config_print.h"

#include <nlohmann/json.hpp>
#include <set>

namespace gestalt::config {

namespace {

using nlohmann::json;

/// Text in double quotes; JSON's escapes are also YAML's.
std::string quoted(const std::string& text) { return json(text).dump(-1, ' ', false, json::error_handler_t::replace); }

/// A name as it is where YAML reads it as text, else in quotes.
std::string word(const std::string& text) {
  static const std::string letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
  static const std::set<std::string> special{"null", "Null", "NULL", "on", "off", "true", "false", "yes", "no"};
  const bool plain = !text.empty() && letters.find(text[0]) != std::string::npos &&
                     text.find_first_not_of(letters + "0123456789-") == std::string::npos && !special.contains(text);
  return plain ? text : quoted(text);
}

std::string on_timeout(const Config& config) { return config.coarse_when_late ? "coarse" : "error"; }

std::string levels(const Config& config) { return config.with_assembly ? "structural+assembly" : "structural"; }

json parameter_values(const ParameterValues& values) {
  json object = json::object();
  for (const auto& [name, value] : values) std::visit([&, &key = name](const auto& v) { object[key] = v; }, value);
  return object;
}

class Yaml {
 public:
  explicit Yaml(const Resolution& resolution) : resolution_(resolution) {}

  std::string write() {
    const Config& config = resolution_.config;
    text_ = "schema_version: 1\n";
    write_directories();
    write_value(0, "levels", "levels", levels(config));
    write_value(0, "time_budget", "time_budget", std::to_string(config.time_budget));
    write_value(0, "on_timeout", "on_timeout", on_timeout(config));
    write_value(0, "model", "model", config.model.empty() ? "none" : quoted(config.model.string()));
    write_values(0, "sensor", "sensor", config.sensor);
    section(0, "signal");
    write_component(1, "clusterer", "signal.clusterer", config.clusterer);
    write_value(1, "working_resolution", "signal.working_resolution", std::to_string(config.working_resolution));
    section(0, "primitive");
    write_list(1, "fitters", "primitive.fitters", config.fitters, resolution_.removed_fitters);
    write_values(1, "model_selection", "primitive.model_selection", config.surface_modelling);
    write_level(Level::structural, config.structural);
    if (config.assembly) write_level(Level::assembly, *config.assembly);
    section(0, "decision");
    write_component(1, "solver", "decision.solver", config.solver);
    write_values(1, "figure_ground", "decision.figure_ground", config.figure_ground);
    return std::move(text_);
  }

 private:
  void line(int level, const std::string& content) {
    text_ += std::string(2 * std::size_t(level), ' ') + content + "\n";
  }
  void section(int level, const std::string& key) { line(level, key + ":"); }

  std::string provenance(const std::string& path) const { return "  # " + resolution_.provenance.at(path); }

  void write_value(int level, const std::string& key, const std::string& path, const std::string& value) {
    line(level, key + ": " + value + provenance(path));
  }

  void write_directories() {
    if (!resolution_.plugin_directories.empty()) section(0, "plugin_directories");
    for (std::size_t i = 0; i < resolution_.plugin_directories.size(); ++i)
      line(1, "- " + quoted(resolution_.plugin_directories[i].string()) +
                  provenance("plugin_directories[" + std::to_string(i) + "]"));
  }

  void write_values(int level, const std::string& key, const std::string& path, const ParameterValues& values) {
    if (values.empty()) return;
    section(level, key);
    for (const auto& [name, value] : values) {
      const auto* text = std::get_if<std::string>(&value);
      write_value(level + 1, name, join(path, name), text ? word(*text) : to_string(value));
    }
  }

  void write_level(Level level, const LevelConfig& config) {
    const std::string path = name_of(level);
    section(0, path);
    const auto removed = resolution_.removed_relations.find(level);
    write_list(1, "relations", path + ".relations", config.relations,
               removed == resolution_.removed_relations.end() ? std::vector<std::string>{} : removed->second);
    write_component(1, "classifier", path + ".classifier", config.classifier);
    write_value(1, "minimum_size", path + ".minimum_size", std::to_string(config.minimum_size));
    write_value(1, "negatives", path + ".negatives", std::to_string(config.negatives));
  }

  void write_component(int level, const std::string& key, const std::string& path, const ComponentConfig& component) {
    section(level, key);
    write_value(level + 1, "plugin", join(path, "plugin"), word(component.plugin));
    write_values(level + 1, "params", join(path, "params"), component.params);
    if (!component.values.empty())
      write_value(level + 1, "values", join(path, "values"), json(component.values).dump());
  }

  void write_list(int level, const std::string& key, const std::string& path,
                  const std::vector<ComponentConfig>& components, const std::vector<std::string>& removed) {
    section(level, key);
    for (const ComponentConfig& component : components)
      write_component(level + 1, word(component.name), join(path, component.name), component);
    // Only a comment: taken out of a list that does not have it, a component would be an error.
    for (const std::string& name : removed) line(level + 1, "# " + name + ": off" + provenance(join(path, name)));
  }

  const Resolution& resolution_;
  std::string text_;
};

json component_values(const ComponentConfig& component) {
  json values{{"plugin", component.plugin}, {"params", parameter_values(component.params)}};
  if (!component.values.empty()) values["values"] = component.values;
  return values;
}

/// A JSON object has no order, and that of components counts.
json list_values(const std::vector<ComponentConfig>& components) {
  json list = json::array();
  for (const ComponentConfig& component : components) {
    list.push_back(component_values(component));
    list.back()["name"] = component.name;
  }
  return list;
}

json level_values(const LevelConfig& level) {
  return {{"relations", list_values(level.relations)},
          {"classifier", component_values(level.classifier)},
          {"minimum_size", level.minimum_size},
          {"negatives", level.negatives}};
}

}  // namespace

std::string to_yaml(const Resolution& resolution) { return Yaml(resolution).write(); }

json to_json(const Resolution& resolution) {
  const Config& config = resolution.config;
  json directories = json::array();
  for (const auto& directory : resolution.plugin_directories) directories.push_back(directory.string());
  json values{
      {"schema_version", 1},
      {"levels", levels(config)},
      {"time_budget", config.time_budget},
      {"on_timeout", on_timeout(config)},
      {"model", config.model.empty() ? json() : json(config.model.string())},
      {"sensor", parameter_values(config.sensor)},
      {"plugin_directories", directories},
      {"signal",
       {{"clusterer", component_values(config.clusterer)}, {"working_resolution", config.working_resolution}}},
      {"primitive",
       {{"fitters", list_values(config.fitters)}, {"model_selection", parameter_values(config.surface_modelling)}}},
      {"structural", level_values(config.structural)},
      {"decision",
       {{"solver", component_values(config.solver)}, {"figure_ground", parameter_values(config.figure_ground)}}}};
  if (config.assembly) values["assembly"] = level_values(*config.assembly);
  return {{"values", values}, {"provenance", resolution.provenance}};
}

}  // namespace gestalt::config
