// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace gestalt {

/// How a JPEG or PNG file says that its pixels are to be shown, by its EXIF data: 1, as they are stored, or 2 to 8,
/// turned or mirrored. 1 where it says nothing. Pixels of intrinsics and of depth are the stored ones.
int stored_orientation(std::string_view bytes);

}  // namespace gestalt
