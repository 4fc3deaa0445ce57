// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace gestalt {

/// The bytes of a file. Throws InputError when it cannot be read.
std::string whole_file(const std::filesystem::path& file);

}  // namespace gestalt
