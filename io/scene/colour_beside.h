// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/io/scene/input.h"

namespace gestalt {

/// Gives a cloud or array file without colour that of the image of the same name beside it (scan.png or .jpg beside
/// scan.pcd), where there is one of the same view; which is a note; one of another view is
/// left out, which is a warning.
void add_colour_beside(const std::filesystem::path& scene, Input& input);

/// Gives such a file the colour of an image. Throws InputError where that is not of the same view.
void set_colour(const std::filesystem::path& image, const std::filesystem::path& scene, Input& input);

}  // namespace gestalt
