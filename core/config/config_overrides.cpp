// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "config_overrides.h"

#include <algorithm>

#include "config_yaml.h"

namespace gestalt::config {

namespace {

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> keys{""};
  for (const char c : path) {
    if (c == '.')
      keys.emplace_back();
    else
      keys.back() += c;
  }
  return keys;
}

Node read_value(const std::string& text, const Place& place, Problems& problems) {
  if (text.starts_with('[') || text.starts_with('{')) return parse_yaml(text, place.source, problems);
  if (!text.empty()) return scalar(text, place);
  Node nothing;
  nothing.place = place;
  return nothing;
}

}  // namespace

Node read_override(const std::string& text, Problems& problems) {
  const auto source =
      std::make_shared<const Source>(Source{"--set " + text, "--set", std::filesystem::current_path(), false});
  const Place place{source, 1, 1};
  Node nothing;
  nothing.place = place;

  const std::size_t equals = text.find('=');
  const std::vector<std::string> keys = split(text.substr(0, equals));
  if (equals == std::string::npos || std::any_of(keys.begin(), keys.end(), [](auto& key) { return key.empty(); })) {
    problems.add(place, "", "expected path=value, as in structural.minimum_size=50");
    return nothing;
  }
  if (keys[0] == "schema_version" || keys[0] == "extends") {
    problems.add(place, keys[0], "can be set only in a file, not on the command line");
    return nothing;
  }
  Node node = read_value(text.substr(equals + 1), place, problems);
  for (auto key = keys.rbegin(); key != keys.rend(); ++key) {
    Node outer;
    outer.kind = Node::Kind::mapping;
    outer.place = place;
    outer.entries.push_back({*key, place, std::move(node)});
    node = std::move(outer);
  }
  return node;
}

}  // namespace gestalt::config
