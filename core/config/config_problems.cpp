// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "config_problems.h"

#include <algorithm>
#include <tuple>

#include "gestalt/core/base/error.h"

namespace gestalt::config {

void Problems::add(const Place& place, const std::string& path, const std::string& message) {
  std::string text = place.text() + ": " + (path.empty() ? "" : path + ": ") + message;
  // Quoted YAML can hold any character; one that breaks lines or steers a terminal must not reach it.
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  problems_.push_back({place, std::move(text)});
}

void Problems::throw_if_any(const std::string& remark) const {
  if (problems_.empty()) return;
  std::vector<Problem> sorted = problems_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Problem& a, const Problem& b) {
    return std::tie(a.place.source->name, a.place.line, a.place.column) <
           std::tie(b.place.source->name, b.place.line, b.place.column);
  });
  std::string text;
  for (const Problem& problem : sorted) text += (text.empty() ? "" : "\n") + problem.text;
  throw ConfigError(text + remark);
}

}  // namespace gestalt::config
