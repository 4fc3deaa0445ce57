// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "gestalt/io/scene/pcd_header.h"

namespace gestalt {

/// The points of a PCD file one after another, each as the header lays it out. Throws InputError for damaged data.
std::string read_pcd_body(const std::filesystem::path& file, const PcdHeader& header, std::string_view bytes);

}  // namespace gestalt
