// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "layout.h"

namespace gestalt::synthesis {

/// lay_out() for the categories that stand in a room.
std::optional<Arrangement> lay_out_in_room(Category category, const Camera& camera, Random& random);

}  // namespace gestalt::synthesis
