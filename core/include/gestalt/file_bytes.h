// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "gestalt/export.h"

namespace gestalt {

/// The whole content of a regular file, not empty. Throws InputError naming the file and the reason; for one of more
/// than most bytes before memory is taken.
GESTALT_EXPORT std::string read_bytes(const std::filesystem::path& file, std::uintmax_t most);

}  // namespace gestalt
