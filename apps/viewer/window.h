// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace gestalt::view {

/// Shows results one at a time in PCL's viewer, until its window is closed. Needs a display. Throws InputError for a
/// result that cannot be read.
void show(const std::vector<std::filesystem::path>& folders);

/// Writes a PNG of what show() would begin with.
void take_picture(const std::filesystem::path& folder, const std::filesystem::path& picture);

}  // namespace gestalt::view
