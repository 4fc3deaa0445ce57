// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "body.h"

namespace gestalt::synthesis {

/// Cutlery, pens, thin boxes, slabs, tubes, cubes and balls: 4-40 mm in at least one direction.
Body random_small_thing(const Palette& palette, Random& random);

}  // namespace gestalt::synthesis
