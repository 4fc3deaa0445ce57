// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "gestalt/io/scene/pcd_header.h"

namespace gestalt {

/// The vertices of a PLY file (1.0, ascii or binary_little_endian), as the header of a PCD file would declare them: an
/// unorganized cloud. Vertices come first in the file; what follows them is left out. Throws InputError with the line.
PcdHeader parse_ply_header(const std::filesystem::path& file, std::string_view bytes);

}  // namespace gestalt
