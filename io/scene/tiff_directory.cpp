// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tiff_directory.h"

namespace gestalt {

std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t size, bool big_endian) {
  if (at > bytes.size() || bytes.size() - at < size) return 0;
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t byte = at + (big_endian ? i : size - 1 - i);
    value = value << 8 | static_cast<unsigned char>(bytes[byte]);
  }
  return value;
}

std::uint32_t tiff_value(std::string_view tiff, std::uint32_t tag) {
  constexpr std::uint32_t short_type = 3;
  const bool big_endian = tiff.starts_with('M');
  const std::size_t directory = number_at(tiff, 4, 4, big_endian);
  const std::size_t entries = number_at(tiff, directory, 2, big_endian);
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t at = directory + 2 + 12 * i;
    if (number_at(tiff, at, 2, big_endian) != tag) continue;
    const std::size_t size = number_at(tiff, at + 2, 2, big_endian) == short_type ? 2 : 4;
    value = number_at(tiff, at + 8, size, big_endian);
  }
  return value;
}

}  // namespace gestalt
