// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "assignments.h"

#include <algorithm>

namespace gestalt {

namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  text.remove_prefix(std::min(text.find_first_not_of(blank), text.size()));
  return text.substr(0, text.find_last_not_of(blank) + 1);
}

/// Calls use(line), without blanks around it, until it returns false; whether it never did.
template <class Use>
bool for_each_line(std::string_view text, const Use& use) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (!use(trimmed(line))) return false;
  }
  return true;
}

bool is_comment(std::string_view line) { return line.empty() || line[0] == '#' || line[0] == ';'; }

bool is_section(std::string_view line) { return line.size() > 2 && line.front() == '[' && line.back() == ']'; }

bool is_key(std::string_view key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
           c == '-';
  });
}

/// In single quotes, where a quote is written twice.
std::string in_quotes(std::string_view value) {
  std::string text = "'";
  for (const char c : value) text.append(c == '\'' ? 2 : 1, c);
  return text + "'";
}

}  // namespace

bool is_assignments(std::string_view text) {
  int assignments = 0;
  const bool all = for_each_line(text, [&](std::string_view line) {
    if (is_comment(line)) return true;
    if (is_section(line)) return is_key(trimmed(line.substr(1, line.size() - 2)));
    const std::size_t equals = line.find('=');
    ++assignments;
    return equals != line.npos && is_key(trimmed(line.substr(0, equals)));
  });
  return all && assignments > 0;
}

std::string yaml_of_assignments(std::string_view text) {
  std::string yaml;
  const char* indentation = "";
  for_each_line(text, [&](std::string_view line) {
    if (is_section(line)) {
      yaml.append(trimmed(line.substr(1, line.size() - 2))).append(":");
      indentation = "  ";
    } else if (!is_comment(line)) {
      const std::size_t equals = line.find('=');
      const std::string_view key = trimmed(line.substr(0, equals)), value = trimmed(line.substr(equals + 1));
      // Where it stands in the file, which messages tell.
      const std::size_t column = line.size() - value.size(), gap = std::max(column, key.size() + 2) - key.size() - 1;
      yaml.append(indentation).append(key).append(":").append(gap, ' ').append(in_quotes(value));
    }
    yaml += '\n';
    return true;
  });
  return yaml;
}

}  // namespace gestalt
