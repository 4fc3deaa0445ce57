// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "packing.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "grocery.h"
#include "shapes.h"

namespace gestalt::synthesis {

namespace {

/// How the packages of one block look.
struct Product {
  bool bare;  // cardboard
  bool same;  // equal ones are copies of the first
  double gap;
};

Product random_product(Random& random) {
  static const double gaps[] = {0, 0.0005, 0.0015};
  return {random.chance(0.35), random.chance(0.5), random.pick(gaps)};
}

/// Packages of one layer, their lower sides at z. False when one does not fit: what lay on top would float.
bool lay_layer(Tabletop& tabletop, const std::vector<Eigen::AlignedBox2d>& pieces, double z, double height,
               const Eigen::Isometry3d& pose, const Product& product, const Palette& palette, Random& random) {
  std::optional<Body> first;
  bool complete = true;
  for (const Eigen::AlignedBox2d& piece : pieces) {
    const Eigen::Vector2d size = piece.sizes();
    const Eigen::Vector3d outer(size.x() - product.gap, size.y() - product.gap, height);
    const bool copy = product.same && first && (first->size - outer).norm() < 1e-6;
    const Palette& own = copy || product.bare || random.chance(0.7) ? palette : random_palette(random);
    Body body = copy ? *first : package(outer, product.bare, own, random);
    if (!first) first = body;
    const Eigen::Vector2d at = piece.center();
    body.pose = pose * Eigen::Translation3d(at.x(), at.y(), z) *
                Eigen::AngleAxisd(random.chance(0.3) ? turn / 2 : 0, Eigen::Vector3d::UnitZ());
    complete &= tabletop.put(body);
  }
  return complete;
}

/// A part of a rectangle that keeps its left front corner.
Eigen::AlignedBox2d part_of(const Eigen::AlignedBox2d& whole, double x_share, double y_share) {
  return {whole.min(), Eigen::Vector2d(whole.min() + whole.sizes().cwiseProduct(Eigen::Vector2d(x_share, y_share)))};
}

}  // namespace

std::vector<Eigen::AlignedBox2d> cut_up(const Eigen::AlignedBox2d& rectangle, int pieces, double least,
                                        Random& random) {
  std::vector<Eigen::AlignedBox2d> parts{rectangle};
  while (int(parts.size()) < pieces) {
    const auto largest = std::max_element(parts.begin(), parts.end(),
                                          [](const auto& a, const auto& b) { return a.volume() < b.volume(); });
    const int axis = largest->sizes().x() >= largest->sizes().y() ? 0 : 1;
    const double length = largest->sizes()[axis];
    if (length < 2 * least) break;
    const double cut =
        std::clamp((random.chance(0.4) ? 0.5 : random.uniform(0.33, 0.67)) * length, least, length - least);
    Eigen::AlignedBox2d rest = *largest;
    rest.min()[axis] += cut;
    largest->max()[axis] = rest.min()[axis];
    parts.push_back(rest);
  }
  return parts;
}

std::vector<Eigen::AlignedBox2d> grid_of(const Eigen::AlignedBox2d& rectangle, int columns, int rows) {
  std::vector<Eigen::AlignedBox2d> parts;
  const Eigen::Vector2d size = rectangle.sizes().cwiseQuotient(Eigen::Vector2d(columns, rows));
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Eigen::Vector2d corner = rectangle.min() + size.cwiseProduct(Eigen::Vector2d(column, row));
      parts.emplace_back(corner, Eigen::Vector2d(corner + size));
    }
  return parts;
}

bool pack(Tabletop& tabletop, const Eigen::AlignedBox2d& rectangle, const Eigen::Isometry3d& pose, int layers,
          Brands& brands, Random& random) {
  const std::size_t before = tabletop.bodies().size();
  const Product product = random_product(random);
  const Palette palette = brands.next();
  const Eigen::Vector2d size = rectangle.sizes();
  const bool regular = random.chance(0.5);
  const double piece = random.uniform(0.055, 0.14);
  const int columns = std::clamp(int(size.x() / piece), 1, 5), rows = std::clamp(int(size.y() / piece), 1, 3);
  double height = random.uniform(0.03, 0.16), z = 0;
  double columns_left = columns, rows_left = rows;
  for (int layer = 0; layer < layers; ++layer) {
    const Eigen::AlignedBox2d ground = part_of(rectangle, columns_left / columns, rows_left / rows);
    const auto pieces = regular ? grid_of(ground, int(columns_left), int(rows_left))
                                : cut_up(ground, int(columns_left * rows_left), 0.04, random);
    if (!lay_layer(tabletop, pieces, z, height, pose, product, palette, random)) break;
    z += height;
    if (!product.same) height = random.uniform(0.03, 0.12);
    // The next layer covers some of the columns and rows.
    if (columns_left > 1 && random.chance(0.7)) columns_left = random.integer(1, int(columns_left));
    if (rows_left > 1 && random.chance(0.5)) --rows_left;
    if (z + height > 0.35) break;
  }
  return tabletop.bodies().size() >= before + 2;
}

int line_up(Tabletop& tabletop, double left, double right, double front, double depth, double highest, Brands& brands,
            Random& random) {
  int standing = 0;
  for (double x = left; x < right;) {
    Body body = random_grocery(brands.next(), random);
    const int copies = random.chance(0.45) ? random.integer(2, 3) : 1;
    if (body.size.y() > depth || body.size.z() > highest) {
      x += 0.02;
      continue;
    }
    for (int copy = 0; copy < copies && x + body.size.x() < right; ++copy) {
      body.pose = Eigen::Translation3d(x + body.size.x() / 2, front + body.size.y() / 2 + random.uniform(0, 0.008), 0);
      if (tabletop.put(body)) ++standing;
      x += body.size.x() + (random.chance(0.6) ? 0.0005 : random.uniform(0.001, 0.015));
    }
    if (random.chance(0.3)) x += random.uniform(0.01, 0.08);
  }
  return standing;
}

}  // namespace gestalt::synthesis
