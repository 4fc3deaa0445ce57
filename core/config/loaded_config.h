// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/config/config.h"

namespace gestalt {

/// A config with the plugins that it chooses from.
struct GESTALT_EXPORT LoadedConfig {
  /// With the plugins of plugin_search_path(). Throws ConfigError.
  explicit LoadedConfig(ConfigTree tree);

  /// With the components of a registry, such as those of a program of one's own.
  LoadedConfig(ConfigTree tree, Registry registry);

  ConfigTree tree;
  Registry registry;
  Config config;
};

}  // namespace gestalt
