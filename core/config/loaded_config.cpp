// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/config/loaded_config.h"

namespace gestalt {

LoadedConfig::LoadedConfig(ConfigTree from)
    : tree(std::move(from)), registry(plugin_search_path(tree.plugin_directories())), config(tree.resolve(registry)) {}

LoadedConfig::LoadedConfig(ConfigTree from, Registry components)
    : tree(std::move(from)), registry(std::move(components)), config(tree.resolve(registry)) {}

}  // namespace gestalt
