// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace gestalt {

// Text of lines "key = value", as ScanNet and INI files have them, perhaps below lines "[section]"; # and ; begin lines
// of comment.

/// Whether a text is one: each line of it.
bool is_assignments(std::string_view text);

/// The same as YAML, line by line: values are texts, sections are maps.
std::string yaml_of_assignments(std::string_view text);

}  // namespace gestalt
