// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gestalt::config {

/// A text that config values are read from: a file, or one override of the command line.
struct Source {
  std::string name;                 ///< in errors: the file, or "--set path=value"
  std::string label;                ///< as provenance: "default.yaml", or "--set"
  std::filesystem::path directory;  ///< absolute; what relative paths in it are relative to
  bool has_lines;                   ///< false for an override
};

/// Where in a source something stands; line and column count from 1.
struct Place {
  std::shared_ptr<const Source> source;
  int line = 1;
  int column = 1;

  /// For errors: "configs/default.yaml:12:3", or "--set path=value".
  std::string text() const;
  /// For provenance: "default.yaml:12", or "--set".
  std::string provenance() const;
};

struct Entry;

/// A piece of YAML whose scalars are still text: only what declares a parameter knows its type.
struct Node {
  enum class Kind { null, scalar, list, mapping };

  Kind kind = Kind::null;
  std::string text;            ///< scalar
  bool quoted = false;         ///< scalar in quotes, or a block of text
  std::vector<Entry> entries;  ///< list (keys are empty) or mapping, in the order of the text
  Place place;

  /// Null when this is not a mapping or has no such key.
  const Node* find(std::string_view key) const;

  /// What an error says was got: "'text'", "a list", "a mapping" or "nothing".
  std::string description() const;
};

/// An item of a list, or a key with its value.
struct Entry {
  std::string key;
  Place place;  ///< of the key
  Node value;
};

Node scalar(std::string text, const Place& place);

/// "a.b", or "b" when path is empty.
std::string join(const std::string& path, std::string_view key);

}  // namespace gestalt::config
