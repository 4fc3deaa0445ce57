// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/scene.h"

namespace gestalt {

Scene::Scene(std::shared_ptr<const Images> images, PatchMap patches, SurfaceSet surfaces)
    : images_(std::move(images)), patches_(std::move(patches)), surfaces_(std::move(surfaces)) {}

Scene::Scene(Frame frame, PatchMap patches, SurfaceSet surfaces)
    : Scene(std::make_shared<const Images>(std::move(frame)), std::move(patches), std::move(surfaces)) {}

const std::vector<std::vector<Contour>>& Scene::contours() const {
  std::call_once(contours_once_, [this] { contours_ = find_contours(surfaces_); });
  return contours_;
}

const BoundaryLines& Scene::boundary_lines() const {
  std::call_once(lines_once_, [this] { lines_ = find_boundary_lines(frame(), surfaces_, contours()); });
  return lines_;
}

const std::vector<Closure>& Scene::closures() const {
  std::call_once(closures_once_, [this] { closures_ = find_closures(frame(), surfaces_, boundary_lines()); });
  return closures_;
}

const std::vector<Outline>& Scene::outlines() const {
  std::call_once(outlines_once_, [this] { outlines_ = find_outlines(frame(), surfaces_, contours()); });
  return outlines_;
}

}  // namespace gestalt
