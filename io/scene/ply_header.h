// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "gestalt/io/scene/pcd_header.h"

namespace gestalt {

/// What the header of a PLY file (1.0) declares, up to its vertices.
struct PlyHeader {
  /// A number, or a list of them.
  struct Property {
    int size;             ///< bytes of a number
    int length_size = 0;  ///< bytes of the list's length that stands before it; 0: no list
    char length_type = 'U';
  };
  struct Element {
    std::size_t count;
    std::vector<Property> properties;
  };

  PcdHeader vertices;           ///< as the header of a PCD file would declare them: an unorganized cloud
  bool big_endian = false;      ///< the numbers of a binary file
  std::vector<Element> before;  ///< the elements before the vertices in the file
};

/// Elements after the vertices are left out. Throws InputError with the line.
PlyHeader parse_ply_header(const std::filesystem::path& file, std::string_view bytes);

}  // namespace gestalt
