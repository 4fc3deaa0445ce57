// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/scene/frame.h"

namespace gestalt::bench {

/// A 640x480 frame that falls into columns x rows planar patches: facets of equal size in the image, tilted in turn to
/// the left and right and up and down, which meet in ridges and valleys 0.8 m away. Every facet has its own colour.
Frame facets(int columns, int rows);

}  // namespace gestalt::bench
