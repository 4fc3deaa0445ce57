// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "body.h"

namespace gestalt::synthesis {

/// A carton whose edges are worn: a line of another shade runs round each face. bare: of cardboard, with tape and a
/// label, else printed.
Body package(const Eigen::Vector3d& size, bool bare, const Palette& palette, Random& random);

/// What a shop sells: cartons, cans, bottles, tubs, bags that stand and bags that lie.
Body random_grocery(const Palette& palette, Random& random);

}  // namespace gestalt::synthesis
