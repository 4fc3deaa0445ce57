// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "gestalt/io/scene/depth_reading.h"

namespace gestalt {

/// Asks whether depth can be what it was read as: by its range, how fine it is, its low bits and whether planes are
/// flat in it. Throws InputError, with the option that mends it, where it cannot be; adds to the warnings where it
/// probably is not. A given unit is doubted only where nothing could be seen in it. name: of the input, in
/// messages. Looks at some thousand pixels, whatever the size.
GESTALT_EXPORT void question_depth(const std::string& name, const DepthReading& depth, const Camera& camera,
                                   std::vector<std::string>& warnings);

}  // namespace gestalt
