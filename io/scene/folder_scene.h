// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/io/scene/input.h"

namespace gestalt {

/// Whether the folder has depth.png or rgb.png: one that lacks its depth counts, so that reading it reports that.
bool is_scene_folder(const std::filesystem::path& folder);

/// Reads depth.png and, where they are, rgb.png and label.png. Throws InputError.
Input read_scene_folder(const std::filesystem::path& folder, const ReadOptions& options);

}  // namespace gestalt
