// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "gestalt/export.h"

namespace gestalt {

/// The whole content of a regular file, not empty. Throws InputError naming the file and the reason.
GESTALT_EXPORT std::string read_bytes(const std::filesystem::path& file);

}  // namespace gestalt
