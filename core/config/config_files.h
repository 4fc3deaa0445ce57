// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config_node.h"
#include "config_problems.h"

namespace gestalt::config {

/// Reads a config file and the chain of files that it extends; the file itself comes last. Each root is a mapping, or
/// empty with a problem added. Throws ConfigError for a file that cannot be read or is not valid YAML, and a chain that
/// comes back to itself or is longer than 16 files; other problems are added.
std::vector<Node> read_files(const std::filesystem::path& file, Problems& problems);

/// The root of a text that is not a file and so extends none; name is what errors and provenance call it, and relative
/// paths in it are relative to the current folder. A mapping, or empty with a problem added. Throws ConfigError for
/// what is not valid YAML.
Node read_root(const std::string& name, const std::string& text, Problems& problems);

}  // namespace gestalt::config
