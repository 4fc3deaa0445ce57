// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gestalt {

/// A number as people and programs write it: 525, "5.25e2", +525, and 525,5 where a decimal comma cannot be taken for
/// thousands. Nothing for what is not a finite number.
std::optional<double> number_of(std::string_view text);

/// The keys of a camera file with what stands under them, and what is found wrong with them.
class CameraEntries {
 public:
  /// root must be a map; file is for messages. is_json: a program wrote it.
  CameraEntries(std::filesystem::path file, const YAML::Node& root, bool is_json = false);

  bool is_json() const { return json_; }

  bool has(std::string_view key) const { return entries_.count(key) > 0; }
  /// The first of the keys that is there, "" when none is.
  std::string first_of(const std::vector<std::string>& keys) const;
  std::vector<std::string> keys() const;
  const YAML::Node& node(std::string_view key) const { return entries_.find(key)->second.value; }

  /// The number under a key, which must lie in [low, high]; meaning is for messages. Nothing when it is wrong, which is
  /// kept for check().
  std::optional<double> number(const std::string& key, double low, double high, const std::string& meaning) {
    return number(key, low, high, meaning, "a number");
  }
  std::optional<int> whole_number(const std::string& key, int low, int high, const std::string& meaning);

  /// The numbers of a list, of lists in a list, of a matrix (its data), or of a text of numbers; empty when the key
  /// is not there, nothing when it holds anything else, which is kept for check().
  std::optional<std::vector<double>> numbers(const std::string& key);

  /// What is written under a key, in small letters; "" when it is not a word.
  std::string word(const std::string& key) const;

  /// Keeps what is wrong with a key's value; of {} the map itself.
  void complain(const std::string& key, const std::string& message);
  void complain_of_key(const std::string& key, const std::string& message);

  /// Throws InputError with all that was wrong, each `file:line:column: message`, counted from 1. format, where it is
  /// not empty, says what the file was taken for.
  void check(const std::string& format = "") const;

 private:
  struct Entry {
    YAML::Node value;
    YAML::Mark key_mark;
  };

  std::optional<double> number(const std::string& key, double low, double high, const std::string& meaning,
                               const std::string& kind);
  void complain_at(const YAML::Mark& mark, const std::string& message);

  std::filesystem::path file_;
  bool json_;
  YAML::Mark start_;
  std::map<std::string, Entry, std::less<>> entries_;
  std::vector<std::string> errors_;
};

}  // namespace gestalt
