// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "config_draft.h"
#include "gestalt/core/config/config.h"

namespace gestalt::config {

/// A config with where every value came from.
struct Resolution {
  Config config;
  std::vector<std::filesystem::path> plugin_directories;
  std::map<std::string, std::string> provenance;  ///< by path: "default.yaml:12", "--set" or "default"
  std::vector<std::string> removed_fitters;       ///< names of those that are off; their provenance is that of the name
  std::map<Level, std::vector<std::string>> removed_relations;
};

/// Compares a draft with what the plugins declare and fills in defaults. Throws ConfigError with every problem of the
/// draft and of this.
Resolution resolve(const Draft& draft, const Registry& registry);

}  // namespace gestalt::config
