// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// Bytes of a model or a result that is read, at most.
constexpr std::uintmax_t largest_json = std::uintmax_t{256} << 20;

/// The whole content of a regular file, not empty. Throws InputError naming the file and the reason; for one of more
/// than most bytes before memory is taken.
GESTALT_EXPORT std::string read_bytes(const std::filesystem::path& file, std::uintmax_t most);

}  // namespace gestalt
