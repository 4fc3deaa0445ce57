// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "gestalt/core/base/export.h"
#include "gestalt/core/base/file_bytes.h"

namespace gestalt {

/// Levels of lists and objects in each other that a JSON text may have: copying, comparing and printing values take
/// stack for each.
constexpr std::size_t deepest_json = 200;

/// The values of a JSON text, which may be untrusted. Throws InputError, with the name and the place, for what
/// is not valid JSON, a number that no double holds, more levels than the deepest, a key that an object has twice, and
/// values that would take memory far beyond the size of the text.
GESTALT_EXPORT nlohmann::json parse_json(const std::string& name, std::string_view text,
                                         std::size_t deepest = deepest_json);

/// The same of a file of at most so many bytes. Throws InputError as read_bytes() does, too.
GESTALT_EXPORT nlohmann::json read_json(const std::filesystem::path& file, std::uintmax_t most = largest_json);

}  // namespace gestalt
