// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "camera_entries.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>
#include <utility>

#include "gestalt/core/base/error.h"
#include "header_line.h"
#include "words.h"

namespace gestalt {

namespace {

constexpr std::size_t most_numbers = 64;  // a camera has no list that is longer
constexpr int deepest_list = 3;

/// Appends the numbers of a node; false when one is none.
bool append_numbers(const YAML::Node& node, int depth, std::vector<double>& all) {
  if (all.size() > most_numbers || depth > deepest_list) return false;
  if (node.IsSequence())
    return std::all_of(node.begin(), node.end(),
                       [&](const YAML::Node& one) { return append_numbers(one, depth + 1, all); });
  if (!node.IsScalar()) return false;
  std::string text = node.Scalar();
  std::replace(text.begin(), text.end(), '\n', ' ');  // a matrix in XML
  for (const std::string_view word : words_of(text)) {
    const auto value = number_of(word);
    if (!value || all.size() > most_numbers) return false;
    all.push_back(*value);
  }
  return true;
}

std::string range(double low, double high) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << low << " to " << high;
  return text.str();
}

}  // namespace

std::optional<double> number_of(std::string_view text) {
  constexpr std::size_t longest = 64;
  const std::vector<std::string_view> words = words_of(text);
  if (words.size() != 1 || words[0].size() > longest) return std::nullopt;
  std::string word(words[0]);
  if (word[0] == '+' && word.size() > 1 && word[1] != '-') word.erase(0, 1);
  // 525,5 has a decimal comma; 1,050 may be a thousand and fifty.
  const std::size_t comma = word.find(',');
  if (comma != word.npos) {
    const std::size_t digits = word.find_first_not_of("0123456789", comma + 1) - comma - 1;
    const bool thousands = word.size() == comma + 4;
    if (word.find('.') != word.npos || comma == 0 || digits == 0 || thousands) return std::nullopt;
    word[comma] = '.';
  }
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

CameraEntries::CameraEntries(std::filesystem::path file, const YAML::Node& root, bool is_json)
    : file_(std::move(file)), json_(is_json), start_(root.Mark()) {
  for (const auto& entry : root) {
    const YAML::Mark mark = entry.first.Mark();
    if (!entry.first.IsScalar())
      complain_at(mark, "a key must be plain text");
    else if (!entries_.emplace(entry.first.Scalar(), Entry{entry.second, mark}).second)
      complain_at(mark, shown(entry.first.Scalar()) + " appears twice; keep one");
  }
}

std::string CameraEntries::first_of(const std::vector<std::string>& keys) const {
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const std::string& key) { return has(key); });
  return found == keys.end() ? "" : *found;
}

std::vector<std::string> CameraEntries::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, entry] : entries_) keys.push_back(key);
  return keys;
}

std::optional<double> CameraEntries::number(const std::string& key, double low, double high, const std::string& meaning,
                                            const std::string& kind) {
  const auto found = entries_.find(key);
  if (found == entries_.end()) {
    complain("", "'" + key + "' is missing: " + meaning);
    return std::nullopt;
  }
  const YAML::Node& node = found->second.value;
  const auto value = node.IsScalar() ? number_of(node.Scalar()) : std::nullopt;
  if (value && *value >= low && *value <= high) return value;
  const bool written = node.IsScalar();
  complain_at(written ? node.Mark() : found->second.key_mark,
              key + (written ? " is " + shown(node.Scalar()) : " has no number") + "; it must be " + kind + " from " +
                  range(low, high) + ": " + meaning);
  return std::nullopt;
}

std::optional<int> CameraEntries::whole_number(const std::string& key, int low, int high, const std::string& meaning) {
  const auto value = number(key, low, high, meaning, "a whole number");
  if (!value) return std::nullopt;
  if (*value == std::floor(*value)) return int(*value);
  complain(key, key + " is " + shown(node(key).Scalar()) + "; it must be a whole number: " + meaning);
  return std::nullopt;
}

std::optional<std::vector<double>> CameraEntries::numbers(const std::string& key) {
  if (!has(key)) return std::vector<double>();
  const YAML::Node& value = node(key);
  const YAML::Node data = value.IsMap() ? value["data"] : value;
  std::vector<double> all;
  if (!data || !append_numbers(data, 0, all)) {
    complain(key, key + " must be a list of numbers");
    return std::nullopt;
  }
  return all;
}

std::string CameraEntries::word(const std::string& key) const {
  if (!has(key) || !node(key).IsScalar()) return "";
  std::string word = node(key).Scalar();
  std::transform(word.begin(), word.end(), word.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  return word;
}

void CameraEntries::complain(const std::string& key, const std::string& message) {
  complain_at(has(key) ? node(key).Mark() : start_, message);
}

void CameraEntries::complain_of_key(const std::string& key, const std::string& message) {
  complain_at(entries_.find(key)->second.key_mark, message);
}

void CameraEntries::complain_at(const YAML::Mark& mark, const std::string& message) {
  const YAML::Mark at = mark.line < 0 ? YAML::Mark() : mark;  // of what was no YAML
  errors_.push_back(file_.string() + ":" + std::to_string(at.line + 1) + ":" + std::to_string(at.column + 1) + ": " +
                    message);
}

void CameraEntries::check(const std::string& format) const {
  std::string text;
  for (const std::string& error : errors_)
    text += (text.empty() ? "" : "\n") + error + (format.empty() ? "" : " (read as " + format + ")");
  if (!text.empty()) throw InputError(text);
}

}  // namespace gestalt
