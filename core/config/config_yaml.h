// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "config_node.h"
#include "config_problems.h"

namespace gestalt::config {

/// Parses one YAML document; an empty text gives a null node. A syntax error, more than one document, nesting deeper
/// than 32 or more than 10000 values (aliases counted as often as they are used) end the reading: throws ConfigError
/// with that and all problems before it. What YAML allows and a config does not - a key that stands twice, merge keys,
/// tags, keys that are not plain text - is added to the problems.
Node parse_yaml(const std::string& text, const std::shared_ptr<const Source>& source, Problems& problems);

}  // namespace gestalt::config
