// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "gestalt/io/scene/frame_files.h"

namespace gestalt {

/// Whether a folder has lists that say which images belong together: associations.txt, or rgb.txt and depth.txt.
bool has_associations(const std::filesystem::path& folder);

/// The frames that associations.txt names, lines "time file time file" of which one is in a folder or of a name with
/// "depth"; else those of rgb.txt and depth.txt, lines "time file" (s): the images that are nearest in time go
/// together, at most 0.02 s apart, each in one frame. In order of depth's time. Throws InputError with the line.
std::vector<FrameFiles> associated_images(const std::filesystem::path& folder);

}  // namespace gestalt
