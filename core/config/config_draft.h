// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "config_node.h"
#include "config_problems.h"

namespace gestalt::config {

/// Values by name, not yet compared with any declaration.
using Settings = std::map<std::string, Entry>;

/// A component as the layers so far ask for it.
struct ComponentDraft {
  std::string name;            ///< in a list; empty for a component that stands alone
  std::optional<Node> plugin;  ///< scalar
  Settings params;
  std::optional<Node> values;  ///< of a relation: a list of scalars, or the scalar all
  bool on = true;              ///< one that is off keeps its position and params, so that 'on' brings it back as it was
  Place place;                 ///< of the last layer that names it; no source before the first
};

struct ComponentListDraft {
  std::vector<ComponentDraft> components;
  std::optional<Place> place;  ///< of the last layer that names the list
  bool relations = false;      ///< its components may have values
};

struct DirectoryDraft {
  std::filesystem::path directory;
  Place place;
};

struct LevelDraft {
  ComponentListDraft relations{{}, {}, true};
  ComponentDraft classifier;
  std::optional<Node> minimum_size;
  std::optional<Node> negatives;

  bool named() const { return relations.place || classifier.plugin || minimum_size || negatives; }
};

/// A config in which layer after layer is merged: the extended files, the file itself, each override.
struct Draft {
  Place start;  ///< of the file itself: where a missing value is reported
  Problems problems;

  std::vector<DirectoryDraft> plugin_directories;
  std::optional<Node> levels;
  std::optional<Node> time_budget;
  std::optional<Node> on_timeout;
  std::optional<Node> model;
  Settings sensor;
  ComponentDraft clusterer;
  std::optional<Node> working_resolution;
  ComponentListDraft fitters;
  Settings model_selection;
  LevelDraft structural;
  LevelDraft assembly;
  ComponentDraft solver;
  Settings figure_ground;
};

/// Merges a layer over the draft. schema_version and extends belong to a file and are left alone;
/// a null root is a layer whose problem is known, and changes nothing.
void merge(Draft& draft, const Node& root);

}  // namespace gestalt::config
