// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// The files that a scene's content follows from, in order of their paths: those of a scene folder and its masks; a
/// cloud, arrays or depth image, files of the same name beside it, the colour image of its frame, the lists of its
/// recording; and its camera file. There may be others among them. Throws nothing: what cannot be read is left out.
GESTALT_EXPORT std::vector<std::filesystem::path> scene_files(const std::filesystem::path& scene);

}  // namespace gestalt
