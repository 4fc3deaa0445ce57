// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "gestalt/core/objects/object_description.h"
#include "mesh.h"
#include "paint.h"
#include "random.h"

namespace gestalt::synthesis {

enum class Kind { carton, can, bowl, mug, bottle, cone, pebble, prism };

/// A rigid thing in its place.
struct Body {
  Mesh mesh;  ///< own frame: standing on z = 0 around the z axis, metres
  Paint paint;
  Eigen::Vector3d size;                                    ///< extent of the mesh along its axes, metres
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< own frame to world
  ShapeKind shape = ShapeKind::other;                      ///< of boxes and plain cylinders
};

/// At the origin, wearing these textures.
Body made_of(Mesh mesh, std::vector<Texture> parts);

/// A carton of this size.
Body carton(const Eigen::Vector3d& size, const Palette& palette, Random& random);

/// A thing of this kind with the proportions of groceries and tableware: 4-30 cm.
Body random_body(Kind kind, const Palette& palette, Random& random);

}  // namespace gestalt::synthesis
