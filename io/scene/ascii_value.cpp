// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ascii_value.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace gestalt {

bool append_value(std::string_view word, const PcdHeader::Field& field, std::string& points) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const auto parse = [&](auto& value) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc{} && end == word.data() + word.size();
  };
  const auto append = [&](const auto& value) { points.append(reinterpret_cast<const char*>(&value), sizeof value); };
  if (field.type == 'F') {
    double value = 0;
    if (!parse(value)) return false;
    if (field.size == 8) return append(value), true;
    if (std::isfinite(value) && std::abs(value) > std::numeric_limits<float>::max()) return false;
    return append(float(value)), true;
  }
  // The lower bytes of the value: PCD files are little-endian, as x86 is.
  const int bits = 8 * field.size;
  std::uint64_t whole = 0;
  if (field.type == 'U') {
    if (!parse(whole) || whole > ~std::uint64_t{0} >> (64 - bits)) return false;
  } else {
    std::int64_t value = 0;
    const std::int64_t high = std::numeric_limits<std::int64_t>::max() >> (64 - bits);
    if (!parse(value) || value > high || value < -high - 1) return false;
    whole = std::uint64_t(value);
  }
  points.append(reinterpret_cast<const char*>(&whole), std::size_t(field.size));
  return true;
}

}  // namespace gestalt
