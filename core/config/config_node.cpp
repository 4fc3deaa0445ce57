// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "config_node.h"

namespace gestalt::config {

// std::to_string, unlike a stream, knows no thousands separators of a locale.
std::string Place::text() const {
  return source->has_lines ? source->name + ":" + std::to_string(line) + ":" + std::to_string(column) : source->name;
}

std::string Place::provenance() const {
  return source->has_lines ? source->label + ":" + std::to_string(line) : source->label;
}

const Node* Node::find(std::string_view key) const {
  if (kind != Kind::mapping) return nullptr;
  for (const Entry& entry : entries)
    if (entry.key == key) return &entry.value;
  return nullptr;
}

std::string Node::description() const {
  switch (kind) {
    case Kind::null:
      return "nothing";
    case Kind::scalar:
      return text.size() <= 80 ? "'" + text + "'" : "'" + text.substr(0, 80) + "...'";
    case Kind::list:
      return "a list";
    case Kind::mapping:
      return "a mapping";
  }
  return "";
}

Node scalar(std::string text, const Place& place) {
  Node node;
  node.kind = Node::Kind::scalar;
  node.text = std::move(text);
  node.place = place;
  return node;
}

std::string join(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : path + "." + std::string(key);
}

}  // namespace gestalt::config
