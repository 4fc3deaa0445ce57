// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/registry.h"
#include "gestalt/core/scene/graph.h"

namespace gestalt {

/// One component as the config asks for it. In YAML: `{plugin: gabor, params: {...}}`, or the bare name. In a list the
/// name under which lists merge is the plugin's, or that of the key `name:`.
struct ComponentConfig {
  std::string name;
  std::string plugin;
  ParameterValues params;  ///< complete: defaults filled in
  /// Of a relation: which of its values a level has, a part of them in the order it declares; empty: all.
  std::vector<std::string> values{};
};

/// How one level groups: sections `structural` and `assembly`.
struct LevelConfig {
  std::vector<ComponentConfig> relations;  ///< not empty
  ComponentConfig classifier;
  int minimum_size = 0;  ///< pixels of a Kinect (pixel_density()); smaller patches have no relations at this level
  int negatives = 0;     ///< largest number of negative pairs of one scene that training uses
};

/// A resolved, validated config.
struct Config {
  bool with_assembly = false;            ///< levels: structural+assembly
  int time_budget = 0;                   ///< milliseconds that a frame may take; 0: any
  bool coarse_when_late = false;         ///< on_timeout: coarse
  std::filesystem::path model;           ///< resolved; empty when the config names none
  ParameterValues sensor;                ///< of SensorParams
  ComponentConfig clusterer;             ///< signal.clusterer
  int working_resolution = 0;            ///< signal.working_resolution: pixels; 0: any number
  std::vector<ComponentConfig> fitters;  ///< primitive.fitters, not empty
  ParameterValues surface_modelling;     ///< primitive.model_selection
  LevelConfig structural;
  std::optional<LevelConfig> assembly;  ///< where the config has this section; never absent when with_assembly
  ComponentConfig solver;               ///< decision.solver
  ParameterValues figure_ground;        ///< decision.figure_ground, of FigureGroundParams
};

/// A config file with everything it extends and the command line's overrides merged (see docs/config.md), before
/// it is validated: that needs the plugins, whose directories only the config knows. Keeps for every value where it
/// came from.
class GESTALT_EXPORT ConfigTree {
 public:
  /// Reads a config; where there is no such file, the installed config of that name, and so for what it extends.
  /// overrides are "path=value" of the command line, applied in order: `structural.relations.gabor=off`
  /// takes a component out of a list, `=on` puts one in, any other path sets a value.
  /// Throws ConfigError when a file cannot be read or is not valid YAML, or extends itself; what else is wrong is
  /// reported by resolve(), all together.
  ConfigTree(const std::filesystem::path& file, const std::vector<std::string>& overrides);

  /// The same of a text, which extends nothing: YAML, or JSON as to_json() has it under "values". name is what messages
  /// and provenance call it.
  static ConfigTree from_text(const std::string& name, const std::string& text,
                              const std::vector<std::string>& overrides);
  ~ConfigTree();
  ConfigTree(ConfigTree&&) noexcept;
  ConfigTree& operator=(ConfigTree&&) noexcept;

  /// plugin_directories of the config; relative entries are relative to the file they stand in.
  std::vector<std::filesystem::path> plugin_directories() const;

  /// Validates against the plugins' declarations. Throws ConfigError with every error of the config together, each
  /// `file:line:column: path: message`, lines and columns counted from 1, with the closest valid key.
  Config resolve(const Registry& registry) const;

  /// The resolved config as YAML that reads back to the same config; each line ends with a comment that says where its
  /// value came from (`# default.yaml:12`, `# --set`, `# default`).
  std::string print(const Registry& registry) const;

  /// {"values": the resolved config, "provenance": {"structural.minimum_size": "default.yaml:12", ...}}
  nlohmann::json to_json(const Registry& registry) const;

 private:
  struct Tree;
  explicit ConfigTree(std::unique_ptr<Tree> tree);
  std::unique_ptr<Tree> tree_;
};

/// configs/default.yaml of this installation or build tree. Throws ConfigError when it is not there.
GESTALT_EXPORT std::filesystem::path default_config();

/// Everything in the config that surfaces and their roles follow from, as text: equal texts give equal ones.
GESTALT_EXPORT std::string canonical_surfaces(const Config& config);

/// Everything in the config that changes a result, as text; the model is not part of it.
GESTALT_EXPORT std::string canonical(const Config& config);

/// Hexadecimal hash (FNV-1a, 64 bits) of everything in the config, but sensor and working resolution, that changes the
/// relation values of a level: two configs with equal hashes can share its model. Throws ConfigError when the config
/// has no such level.
GESTALT_EXPORT std::string config_hash(const Config& config, Level level);

}  // namespace gestalt
