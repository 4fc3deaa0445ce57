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

/// A frame with the results of the signal and primitive level, and what is derived from them that several relations
/// share. What is derived is made once, when it is first asked for; asking is thread-safe.
class GESTALT_EXPORT Scene {
 public:
  /// images must not be null.
  Scene(std::shared_ptr<const Images> images, PatchMap patches, SurfaceSet surfaces);
  Scene(Frame frame, PatchMap patches, SurfaceSet surfaces);
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  const Frame& frame() const { return images_->frame(); }
  const PatchMap& patches() const { return patches_; }
  const SurfaceSet& surfaces() const { return surfaces_; }

  /// Images::grey() and Images::yuv().
  const cv::Mat& grey() const { return images_->grey(); }
  const cv::Mat& yuv() const { return images_->yuv(); }

  /// What a relation observed in the images, which must be a T.
  template <class T>
  const T& observed(const Observer& relation) const {
    return static_cast<const T&>(*images_->observation(relation));
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
  const std::shared_ptr<const Images> images_;
  const PatchMap patches_;
  const SurfaceSet surfaces_;
  mutable std::once_flag contours_once_, outlines_once_, lines_once_, closures_once_;
  mutable std::vector<std::vector<Contour>> contours_;
  mutable std::vector<Outline> outlines_;
  mutable BoundaryLines lines_;
  mutable std::vector<Closure> closures_;
};

}  // namespace gestalt
