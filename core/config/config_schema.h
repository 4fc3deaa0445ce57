// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "gestalt/core/plugin/registry.h"

namespace gestalt {

/// JSON schema (draft 7) of a config file with the plugins of a registry: every key and parameter with type, range,
/// unit, default and text. It knows one file and not what that extends, so that it takes any name in a mapping of
/// components, and any component's params where a file names no plugin.
GESTALT_EXPORT nlohmann::ordered_json config_schema(const Registry& registry);

}  // namespace gestalt
