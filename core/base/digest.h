// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// XXH3 of 128 bits as 32 hexadecimal digits: contents that differ have others, save by intent.
GESTALT_EXPORT std::string digest(std::string_view bytes);

/// The same of a regular file of any size, which is read block by block; links are followed. Throws InputError naming
/// it and the reason.
GESTALT_EXPORT std::string file_digest(const std::filesystem::path& file);

}  // namespace gestalt
