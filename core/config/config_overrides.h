// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "config_node.h"
#include "config_problems.h"

namespace gestalt::config {

/// The layer that an override of the command line stands for: a.b=v is {a: {b: v}}. The value is plain text, or YAML
/// when it begins with [ or {. A null node, with a problem added, when the text is not path=value.
Node read_override(const std::string& text, Problems& problems);

}  // namespace gestalt::config
