// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "difference.h"

#include <algorithm>
#include <cmath>

namespace gestalt {

using nlohmann::json;

namespace {

bool same_number(double a, double b) {
  return a == b || std::abs(a - b) <= 1e-6 * std::max({std::abs(a), std::abs(b), 1e-3});
}

}  // namespace

std::string first_difference(const json& a, const json& b, const std::string& place) {
  if (a.is_number() && b.is_number()) return same_number(a.get<double>(), b.get<double>()) ? "" : place;
  if (a.is_array() && b.is_array()) {
    if (a.size() != b.size()) return place;
    for (std::size_t i = 0; i < a.size(); ++i)
      if (std::string at = first_difference(a[i], b[i], place + "[" + std::to_string(i) + "]"); !at.empty()) return at;
    return "";
  }
  if (a.is_object() && b.is_object()) {
    for (const auto& [key, value] : a.items())
      if (std::string at = !b.contains(key) ? place + "." + key : first_difference(value, b[key], place + "." + key);
          !at.empty())
        return at;
    for (const auto& [key, value] : b.items())
      if (!a.contains(key)) return place + "." + key;
    return "";
  }
  return a == b ? "" : place;
}

}  // namespace gestalt
