// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// Of a PCD or PLY file.
constexpr std::uintmax_t largest_cloud_file = std::uintmax_t{1} << 32;  // bytes

/// What the header of a PCD file (version 0.5, 0.6 or 0.7) declares, checked for consistency.
struct PcdHeader {
  struct Field {
    std::string name;    ///< "_" is padding
    char type;           ///< I signed, U unsigned, F floating point
    int size;            ///< bytes of one element: 1, 2, 4 or 8 as the type allows
    std::size_t count;   ///< elements, >= 1
    std::size_t offset;  ///< bytes from the start of a point

    std::size_t bytes() const { return std::size_t(size) * count; }
  };
  enum class Data { ascii, binary, binary_compressed };

  std::vector<Field> fields;  ///< not empty; names differ, but for padding; without those of count 0
  int width = 0;              ///< columns of an organized cloud, or the number of points
  int height = 0;             ///< rows; 1 for an unorganized cloud
  /// Where the sensor stood in the frame of the points: position in metres, then the quaternion w x y z, not
  /// normalised.
  std::array<double, 7> viewpoint{0, 0, 0, 1, 0, 0, 0};
  Data data = Data::ascii;
  std::size_t body = 0;  ///< offset of the first byte after the header
  int lines = 0;         ///< of the header: the body starts in line lines + 1

  std::size_t points() const { return std::size_t(width) * std::size_t(height); }
  std::size_t point_bytes() const { return fields.back().offset + fields.back().bytes(); }

  /// Null when there is no such field.
  const Field* find(std::string_view name) const;
};

/// "ascii", "binary" or "binary_compressed".
GESTALT_EXPORT const char* to_string(PcdHeader::Data data);

/// Reads the header from the bytes of a PCD file; file is for messages. Throws InputError with the line for anything
/// unknown, missing, repeated or inconsistent, and for clouds of more than 2^26 points or 2^31 bytes.
GESTALT_EXPORT PcdHeader parse_pcd_header(const std::filesystem::path& file, std::string_view bytes);

/// Same, from a file.
GESTALT_EXPORT PcdHeader read_pcd_header(const std::filesystem::path& file);

}  // namespace gestalt
