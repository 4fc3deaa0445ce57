// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <yaml-cpp/yaml.h>

#include <algorithm>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"
#include "gestalt/core/base/suggest.h"
#include "gestalt/core/pipeline/pipeline.h"
#include "gestalt/core/pipeline/relation_table.h"
#include "gestalt/core/plugin/relation.h"
#include "gestalt/evaluation/experiment/ablation.h"
#include "gestalt/io/scene/yaml_document.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

/// Collects what is wrong with a file of overrides.
class VariantsFile {
 public:
  explicit VariantsFile(fs::path file) : file_(std::move(file)) {}

  std::vector<OverrideSet> read() const {
    const YAML::Node root = parse();
    if (!root.IsMap() || root.size() == 0)
      fail({}, "contains no variants; write a line 'name: [path=value, ...]' for each");
    std::vector<OverrideSet> sets;
    for (const auto& entry : root) {
      const YAML::Mark mark = entry.first.Mark();
      if (!entry.first.IsScalar()) fail(mark, "the name of a variant must be plain text");
      OverrideSet set{entry.first.Scalar(), {}};
      for (const OverrideSet& other : sets)
        if (other.name == set.name) fail(mark, "'" + set.name + "' appears twice; keep one");
      if (entry.second.IsScalar()) {
        set.overrides.push_back(entry.second.Scalar());
      } else if (entry.second.IsSequence() && entry.second.size() > 0) {
        for (const YAML::Node& text : entry.second) {
          if (!text.IsScalar()) fail(text.Mark(), "an override must be a text path=value");
          set.overrides.push_back(text.Scalar());
        }
      } else {
        fail(mark, "'" + set.name + "' has no overrides; write [path=value, ...]");
      }
      sets.push_back(std::move(set));
    }
    return sets;
  }

 private:
  YAML::Node parse() const {
    std::string text;
    try {
      text = read_bytes(file_, largest_json);
    } catch (const InputError& error) {
      throw ConfigError(error.what());
    }
    try {
      return load_yaml_document(text);
    } catch (const YAML::Exception& error) {
      fail(error.mark, "is not valid YAML: " + error.msg);
    }
  }

  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& message) const {
    throw ConfigError(file_.string() + ":" + std::to_string(mark.line + 1) + ":" + std::to_string(mark.column + 1) +
                      ": " + message);
  }

  fs::path file_;
};

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == at)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

LevelConfig& level_of(Config& config, Level level, const std::string& target) {
  if (level == Level::structural) return config.structural;
  if (!config.with_assembly)
    throw ConfigError("--each " + target + ": the config has no assembly level; give --set levels=structural+assembly");
  return *config.assembly;
}

/// A relation of a level, or one of several values that the level has of it.
struct Part {
  std::size_t relation;
  std::string value;                ///< empty: the whole relation
  std::vector<std::string> others;  ///< the other values
  std::string name;
};

std::vector<Part> relation_parts(const std::vector<ComponentConfig>& relations) {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < relations.size(); ++i) parts.push_back({i, "", {}, relations[i].name});
  return parts;
}

std::vector<Part> value_parts(const std::vector<ComponentConfig>& relations, const Registry& registry) {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < relations.size(); ++i) {
    const ComponentConfig& relation = relations[i];
    std::vector<std::string> values = relation.values;
    if (values.empty())
      for (const RelationValue& value : registry.create<Relation>(relation.plugin, relation.params)->values())
        values.push_back(value.name);
    for (const std::string& value : values) {
      Part part{i, values.size() > 1 ? value : "", values, value_name(value, relation.name, relation.plugin)};
      std::erase(part.others, value);
      parts.push_back(std::move(part));
    }
  }
  return parts;
}

/// All but the part, or only that.
std::vector<ComponentConfig> reduced(std::vector<ComponentConfig> relations, const Part& part, EachMode mode) {
  const auto relation = relations.begin() + std::ptrdiff_t(part.relation);
  if (!part.value.empty())
    relation->values = mode == EachMode::only ? std::vector{part.value} : part.others;
  else if (mode == EachMode::without)
    relations.erase(relation);
  if (mode == EachMode::only) return {*relation};
  return relations;
}

}  // namespace

std::vector<OverrideSet> read_override_sets(const fs::path& file) { return VariantsFile(file).read(); }

constexpr std::size_t most_variants = 10000;  // a minute or more each

std::vector<OverrideSet> grid(const std::vector<std::string>& axes) {
  std::vector<OverrideSet> sets{{"", {}}};
  for (const std::string& axis : axes) {
    const std::size_t equals = axis.find('=');
    const std::string path = axis.substr(0, equals);
    if (equals == std::string::npos || path.empty())
      throw ConfigError("--grid " + axis + ": expected path=value,value,..., as in structural.minimum_size=30,60");
    const std::vector<std::string> values = split(axis.substr(equals + 1), ',');
    if (values.size() > most_variants / sets.size())
      throw ConfigError("--grid " + axis + ": makes more than " + std::to_string(most_variants) +
                        " variants with the values of the other grids; leave values out");
    std::vector<OverrideSet> longer;
    for (const OverrideSet& set : sets)
      for (const std::string& value : values) {
        if (value.empty()) throw ConfigError("--grid " + axis + ": has an empty value; write path=value,value,...");
        OverrideSet next = set;
        std::string assignment = path;
        assignment.append("=").append(value);
        next.name.append(set.name.empty() ? "" : " ").append(assignment);
        next.overrides.push_back(assignment);
        longer.push_back(std::move(next));
      }
    sets = std::move(longer);
  }
  if (axes.empty()) sets.clear();
  return sets;
}

const std::vector<std::string>& each_targets() {
  static const std::vector<std::string> targets{"structural.relations", "structural.values", "assembly.relations",
                                                "assembly.values"};
  return targets;
}

std::vector<Variant> each(const Variant& base, const Registry& registry, const std::string& target, EachMode mode) {
  if (std::find(each_targets().begin(), each_targets().end(), target) == each_targets().end())
    throw ConfigError("--each " + target + ": there is no such list" + did_you_mean(target, each_targets()) +
                      "; give structural.relations, structural.values, assembly.relations or assembly.values");
  const Level level = target.starts_with("structural") ? Level::structural : Level::assembly;
  Config config = base.config;
  const std::vector<ComponentConfig> relations = level_of(config, level, target).relations;
  const std::vector<Part> parts =
      target.ends_with("values") ? value_parts(relations, registry) : relation_parts(relations);
  if (parts.size() < 2 && mode == EachMode::without)
    throw ConfigError("--each " + target + ": without '" + parts.at(0).name + "' nothing would be left");

  std::vector<Variant> variants;
  for (const Part& part : parts) {
    Variant variant = base;
    variant.name = std::string(mode == EachMode::only ? "only " : "without ") + name_of(level) + "." + part.name;
    level_of(variant.config, level, target).relations = reduced(relations, part, mode);
    variants.push_back(std::move(variant));
  }
  return variants;
}

std::vector<std::string> level_values(const Config& config, const Registry& registry, Level level) {
  return Pipeline(config, registry).expected_model(level).names;
}

}  // namespace gestalt
