// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt::conformance {

/// A scene with a name for messages.
struct NamedScene {
  std::string name;
  test::KnownScene known;
};

/// Small scenes that between them have convex, concave and flat borders, an occlusion, patches far from each other,
/// texture, patches of one pixel, invalid pixels, and images of a few pixels only. Every one has two surfaces at least.
const std::vector<NamedScene>& scenes();

/// The same scene with its surfaces numbered backwards.
test::KnownScene renumbered(const test::KnownScene& known);

}  // namespace gestalt::conformance
