// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// The files beside a result.json that are not those that its "files" names with their digests: of another run, changed
/// since, or being written now. A file that is missing is none of them; content is what read_result_content() gave.
GESTALT_EXPORT std::vector<std::string> foreign_files(const std::filesystem::path& result,
                                                      const nlohmann::json& content);

/// One line on them: what they are, and what to do; "" where there are none.
GESTALT_EXPORT std::string warning_of_foreign_files(const std::filesystem::path& result, const nlohmann::json& content);

/// The files beside a result.json that are as they were written with it, by its digests; none where it cannot be read.
GESTALT_EXPORT std::vector<std::string> own_files(const std::filesystem::path& result);

/// Throws InputError where a result.json lies beside a file and names it with another digest.
GESTALT_EXPORT void require_of_its_result(const std::filesystem::path& file);

}  // namespace gestalt
