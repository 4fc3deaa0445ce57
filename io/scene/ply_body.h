// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "ply_header.h"

namespace gestalt {

/// The vertices of a PLY file one after another, each as the header lays it out, little-endian. In an ascii file they
/// may stand in any number of lines. Throws InputError for damaged data.
std::string read_ply_body(const std::filesystem::path& file, const PlyHeader& header, std::string_view bytes);

}  // namespace gestalt
