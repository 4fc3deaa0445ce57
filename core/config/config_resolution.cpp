// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "config_resolution.h"

#include <algorithm>
#include <optional>
#include <set>

#include "config_keys.h"
#include "gestalt/core/base/suggest.h"
#include "gestalt/core/config/figure_ground_params.h"
#include "gestalt/core/config/sensor_params.h"
#include "gestalt/core/config/surface_modelling_params.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt::config {

namespace fs = std::filesystem;

namespace {

class Resolver {
 public:
  Resolver(const Draft& draft, const Registry& registry)
      : draft_(draft), registry_(registry), problems_(draft.problems) {}

  Resolution resolve() {
    for (std::size_t i = 0; i < draft_.plugin_directories.size(); ++i) {
      result_.plugin_directories.push_back(draft_.plugin_directories[i].directory);
      note("plugin_directories[" + std::to_string(i) + "]", draft_.plugin_directories[i].place);
    }
    Config& config = result_.config;
    config.with_assembly = std::get<std::string>(value(levels_declaration(), draft_.levels, "levels")) == both_levels;
    config.time_budget =
        int(std::get<std::int64_t>(value(time_budget_declaration(), draft_.time_budget, "time_budget")));
    config.coarse_when_late =
        std::get<std::string>(value(on_timeout_declaration(), draft_.on_timeout, "on_timeout")) == "coarse";
    config.model = model();
    config.sensor = values(SensorParams::parameters().declarations(), draft_.sensor, "sensor");
    config.clusterer = single("clusterer", "signal.clusterer", draft_.clusterer);
    config.working_resolution = int(std::get<std::int64_t>(
        value(working_resolution_declaration(), draft_.working_resolution, "signal.working_resolution")));
    config.fitters = list("fitter", "primitive.fitters", draft_.fitters, result_.removed_fitters);
    config.surface_modelling = values(SurfaceModellingParams::parameters().declarations(), draft_.model_selection,
                                      "primitive.model_selection");
    config.structural = level(Level::structural, draft_.structural);
    if (config.with_assembly || draft_.assembly.named()) config.assembly = level(Level::assembly, draft_.assembly);
    config.solver = single("solver", "decision.solver", draft_.solver);
    config.figure_ground =
        values(FigureGroundParams::parameters().declarations(), draft_.figure_ground, "decision.figure_ground");
    problems_.throw_if_any(searched_);
    return std::move(result_);
  }

 private:
  void note(const std::string& path, const Place& place) { result_.provenance[path] = place.provenance(); }

  LevelConfig level(Level level, const LevelDraft& draft) {
    const std::string path = name_of(level);
    return {
        list("relation", path + ".relations", draft.relations, result_.removed_relations[level]),
        single("classifier", path + ".classifier", draft.classifier),
        int(std::get<std::int64_t>(value(minimum_size_declaration(level), draft.minimum_size, path + ".minimum_size"))),
        int(std::get<std::int64_t>(value(negatives_declaration(), draft.negatives, path + ".negatives")))};
  }

  ComponentConfig single(const char* kind, const std::string& path, const ComponentDraft& draft) {
    if (!draft.plugin) {
      problems_.add(draft.place.source ? draft.place : draft_.start, path,
                    "names no plugin; expected the name of a " + std::string(kind) + known(kind));
      return {};
    }
    return component(kind, path, draft, draft.plugin->text);
  }

  std::vector<ComponentConfig> list(const char* kind, const std::string& path, const ComponentListDraft& draft,
                                    std::vector<std::string>& removed) {
    std::vector<ComponentConfig> components;
    for (const ComponentDraft& entry : draft.components) {
      const std::string entry_path = join(path, entry.name);
      if (entry.on) {
        components.push_back(component(kind, entry_path, entry, entry.name));
      } else {
        removed.push_back(entry.name);
        note(entry_path, entry.place);
      }
    }
    if (components.empty())
      problems_.add(draft.place.value_or(draft_.start), path,
                    "the list is empty; it needs at least one " + std::string(kind) + known(kind));
    return components;
  }

  ComponentConfig component(const char* kind, const std::string& path, const ComponentDraft& draft,
                            const std::string& name) {
    const Node& plugin = *draft.plugin;
    note(join(path, "plugin"), plugin.place);
    try {
      ComponentConfig component{name, plugin.text,
                                values(registry_.parameters(kind, plugin.text), draft.params, join(path, "params"))};
      if (draft.values) component.values = relation_values(component, *draft.values, join(path, "values"));
      return component;
    } catch (const PluginError& error) {
      // Where plugins were searched is the same for every missing one and is reported once, at the end.
      const std::string words = error.what();
      problems_.add(plugin.place, path, words.substr(0, words.find('\n')) + known(kind));
      const std::size_t searched = words.find("\n  searched:");
      if (searched != std::string::npos) searched_ = words.substr(searched);
      return {};
    }
  }

  /// The given ones of a relation's values, in its order; none for all of them. They may depend on its params, so that
  /// it has to be made.
  std::vector<std::string> relation_values(const ComponentConfig& component, const Node& given,
                                           const std::string& path) {
    note(path, given.place);
    if (given.kind == Node::Kind::scalar) return {};
    std::vector<std::string> names;
    for (const RelationValue& value : registry_.create<Relation>(component.plugin, component.params)->values())
      names.push_back(value.name);
    std::set<std::string> wanted;
    for (const Entry& entry : given.entries) {
      const std::string& name = entry.value.text;
      if (std::find(names.begin(), names.end(), name) == names.end())
        problems_.add(entry.value.place, path,
                      "'" + component.plugin + "' has no value '" + name + "'" + did_you_mean(name, names));
      wanted.insert(name);
    }
    std::vector<std::string> kept;
    for (const std::string& name : names)
      if (wanted.contains(name)) kept.push_back(name);
    return kept.size() == names.size() ? std::vector<std::string>{} : kept;
  }

  std::string known(const char* kind) const {
    std::string text;
    for (const std::string& name : registry_.names(kind)) text += (text.empty() ? "" : ", ") + name;
    return " (known: " + (text.empty() ? "none" : text) + ")";
  }

  ParameterValues values(const std::vector<Parameter>& declarations, const Settings& given, const std::string& path) {
    std::vector<std::string> names;
    ParameterValues values;
    for (const Parameter& declaration : declarations) {
      names.push_back(declaration.name);
      const auto found = given.find(declaration.name);
      values[declaration.name] =
          value(declaration, found == given.end() ? std::nullopt : std::optional(found->second.value),
                join(path, declaration.name));
    }
    for (const auto& [name, entry] : given)
      if (!values.contains(name))
        problems_.add(entry.place, join(path, name), "unknown parameter" + did_you_mean(name, names));
    return values;
  }

  ParameterValue value(const Parameter& declaration, const std::optional<Node>& given, const std::string& path) {
    if (!given) {
      result_.provenance[path] = "default";
      return declaration.default_value;
    }
    note(path, given->place);
    try {
      ParameterValue value = parse_parameter(declaration, given->text);
      if (given->quoted && declaration.type != Parameter::Type::choice)
        throw ConfigError("expected the value without quotes, got \"" + given->text + "\"");
      return value;
    } catch (const ConfigError& error) {
      problems_.add(given->place, path, error.what());
      return declaration.default_value;
    }
  }

  /// Beside the file that names it, then among the installed models.
  fs::path model() {
    const std::string path = "model";
    if (!draft_.model) {
      result_.provenance[path] = "default";
      return {};
    }
    const Node& name = *draft_.model;
    note(path, name.place);
    if (name.kind == Node::Kind::null || (name.text == "none" && !name.quoted)) return {};
    const fs::path beside = (name.place.source->directory / name.text).lexically_normal();
    const fs::path installed = data_directory() / "models" / name.text;
    std::error_code ignored;
    return !fs::exists(beside, ignored) && fs::exists(installed, ignored) ? installed : beside;
  }

  const Draft& draft_;
  const Registry& registry_;
  Problems problems_;
  std::string searched_;
  Resolution result_;
};

}  // namespace

Resolution resolve(const Draft& draft, const Registry& registry) { return Resolver(draft, registry).resolve(); }

}  // namespace gestalt::config
