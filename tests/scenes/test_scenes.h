// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "gestalt/core/scene/frame.h"
#include "gestalt/core/scene/patch_map.h"
#include "gestalt/core/scene/surface_set.h"

namespace gestalt::test {

/// The Kinect's intrinsics (f = 525 px at 640x480), scaled to the image size.
Camera kinect(int width = 640, int height = 480);

/// A rectangle of pixels that shows a plane in one colour. Later patches cover earlier ones.
struct PlanarPatch {
  cv::Rect pixels;
  Eigen::Vector3f point;            ///< any point of the plane, metres
  Eigen::Vector3f normal;           ///< turned towards the camera by the renderer
  cv::Vec3b colour{128, 128, 128};  ///< blue, green, red
};

/// A frame with known geometry and the exact results of the levels below the relations: one surface for each patch
/// that is visible, in order, with its exact plane as model.
struct KnownScene {
  Frame frame;
  PatchMap patches;
  SurfaceSet surfaces;
};

KnownScene render(const std::vector<PlanarPatch>& patches, const Camera& camera = kinect());

/// The exact plane through a point, as a surface model of type "plane".
std::shared_ptr<const SurfaceModel> exact_plane(const Eigen::Vector3f& point, Eigen::Vector3f normal);

/// The same scene with its points, normals and planes moved rigidly; every pixel stays where it is, so what a relation
/// takes from 3D geometry alone must not change. The motion must leave every patch's front towards the camera.
KnownScene moved(const KnownScene& scene, const Eigen::Isometry3f& motion);

/// A rotation by 0.3 rad about a slanted axis through the camera, and a shift by a few centimetres.
Eigen::Isometry3f some_motion();

/// A box's two visible faces that meet in a vertical ridge in the image's middle, each at 45 degrees to the view:
/// convex (the ridge points at the camera) or concave. Surface 0 is left, 1 right. The ridge is 1 m away.
KnownScene ridge(bool convex);

/// A wall 1.5 m away (surface 0) and a rectangle 1 m away in front of it (surface 1).
KnownScene rectangle_before_wall();

}  // namespace gestalt::test
