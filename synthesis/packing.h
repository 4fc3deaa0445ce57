// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "brands.h"
#include "random.h"
#include "tabletop.h"

namespace gestalt::synthesis {

/// Cuts a rectangle into pieces by cuts from side to side, the largest piece first, across its longer side. They are at
/// least `least` (metres) wide; fewer where there is no room.
std::vector<Eigen::AlignedBox2d> cut_up(const Eigen::AlignedBox2d& rectangle, int pieces, double least, Random& random);

/// Columns x rows equal pieces.
std::vector<Eigen::AlignedBox2d> grid_of(const Eigen::AlignedBox2d& rectangle, int columns, int rows);

/// Packages that fill a rectangle in up to `layers` layers, flush: no gap of more than 1.5 mm, all tops of a layer at
/// one height. True when at least two stand.
bool pack(Tabletop& tabletop, const Eigen::AlignedBox2d& rectangle, const Eigen::Isometry3d& pose, int layers,
          Brands& brands, Random& random);

/// Things side by side from left to right along a line at y = front, none deeper than `depth`, x in [left, right]: one,
/// two or three of a kind. How many stand.
int line_up(Tabletop& tabletop, double left, double right, double front, double depth, double highest, Brands& brands,
            Random& random);

}  // namespace gestalt::synthesis
