// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <opencv2/core.hpp>

#include "gestalt/core/scene/boundary_lines.h"
#include "gestalt/core/scene/closure.h"
#include "gestalt/core/scene/contour.h"
#include "gestalt/core/scene/frame.h"
#include "gestalt/core/scene/images.h"
#include "gestalt/core/scene/outline.h"
#include "gestalt/core/scene/patch_map.h"
#include "gestalt/core/scene/surface_set.h"

namespace gestalt {

/// What a relation sees of a frame: the results of the levels below, and what is derived from them that several
/// relations share. Each derived image is made once, by whoever asks first; asking is thread-safe.
/// Keeps references: images or frame, patches and surfaces must outlive it.
class GESTALT_EXPORT Scene {
 public:
  Scene(const Images& images, const PatchMap& patches, const SurfaceSet& surfaces);

  /// With images of its own.
  Scene(const Frame& frame, const PatchMap& patches, const SurfaceSet& surfaces);
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  const Frame& frame() const { return images_.frame(); }
  const PatchMap& patches() const { return patches_; }
  const SurfaceSet& surfaces() const { return surfaces_; }

  /// Images::grey() and Images::yuv().
  const cv::Mat& grey() const { return images_.grey(); }
  const cv::Mat& yuv() const { return images_.yuv(); }

  /// What a relation observed in the images, which must be a T.
  template <class T>
  const T& observed(const Observer& relation) const {
    return static_cast<const T&>(*images_.observation(relation));
  }

  /// The contours of every surface, by its index.
  const std::vector<std::vector<Contour>>& contours() const;

  /// The straight boundaries of the surfaces and how they go on in each other.
  const BoundaryLines& boundary_lines() const;

  /// Closed convex contours over those lines, cheapest first.
  const std::vector<Closure>& closures() const;

  /// Points on the contours of every surface, by its index.
  const std::vector<Outline>& outlines() const;

 private:
  const std::unique_ptr<const Images> own_images_;
  const Images& images_;
  const PatchMap& patches_;
  const SurfaceSet& surfaces_;
  mutable std::once_flag contours_once_, outlines_once_, lines_once_, closures_once_;
  mutable std::vector<std::vector<Contour>> contours_;
  mutable std::vector<Outline> outlines_;
  mutable BoundaryLines lines_;
  mutable std::vector<Closure> closures_;
};

}  // namespace gestalt
