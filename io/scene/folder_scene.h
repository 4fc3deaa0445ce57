// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/io/scene/input.h"

namespace gestalt {

/// Whether the folder has an image of files_of_scene_folder(): one that lacks its depth counts, so that reading it
/// reports that.
bool is_scene_folder(const std::filesystem::path& folder);

/// Reads depth and, where they are, colour and label.png. Throws InputError.
Input read_scene_folder(const std::filesystem::path& folder, const ReadOptions& options);

}  // namespace gestalt
