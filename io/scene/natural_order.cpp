// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "natural_order.h"

namespace gestalt {

namespace {

bool digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

bool natural_less(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!digit(a[i]) || !digit(b[j])) {
      if (a[i] != b[j]) return static_cast<unsigned char>(a[i]) < static_cast<unsigned char>(b[j]);
      ++i, ++j;
      continue;
    }
    const auto number = [](const std::string& text, std::size_t& at) {
      std::size_t end = at;
      while (end < text.size() && digit(text[end])) ++end;
      while (at + 1 < end && text[at] == '0') ++at;
      const std::string digits = text.substr(at, end - at);
      at = end;
      return digits;
    };
    const std::string m = number(a, i), n = number(b, j);
    if (m.size() != n.size()) return m.size() < n.size();
    if (m != n) return m < n;
  }
  if ((i < a.size()) != (j < b.size())) return j < b.size();
  return a < b;  // learn1 and learn01 are equal numbers but two names
}

}  // namespace gestalt
