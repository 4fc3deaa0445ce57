// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/scene/frame.h"
#include "gestalt/core/scene/patch_map.h"

namespace gestalt {

/// Signal level (paper, Section 3): groups the pixels of a frame to patches.
class GESTALT_EXPORT Clusterer {
 public:
  virtual ~Clusterer();

  /// Const and thread-safe; the result does not depend on the number of threads. Pixels without depth get label 0.
  virtual PatchMap cluster(const Frame& frame) const = 0;
};

}  // namespace gestalt
