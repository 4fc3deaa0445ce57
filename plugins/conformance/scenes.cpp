// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scenes.h"

#include <algorithm>

#include "gestalt/core/pipeline/surface_modelling.h"

namespace gestalt::conformance {

namespace {

const Eigen::Vector3f facing(0, 0, -1);
const Camera camera = test::kinect(160, 120);

test::KnownScene with_texture(test::KnownScene known) {
  cv::RNG random(1);
  random.fill(known.frame.colour, cv::RNG::UNIFORM, 0, 256);
  return known;
}

/// Two faces that meet in a vertical ridge, a wall to their right, and a patch above that touches nothing.
test::KnownScene faces(float side) {
  return test::render({{{30, 40, 30, 50}, {0, 0, 1}, {-side, 0, -1}, {40, 40, 200}},
                       {{60, 40, 30, 50}, {0, 0, 1}, {side, 0, -1}, {200, 40, 40}},
                       {{90, 40, 50, 50}, {0, 0, 1.4f}, facing, {90, 90, 90}},
                       {{40, 5, 40, 20}, {0, 0, 0.8f}, {0, 1, -1}, {0, 255, 0}}},
                      camera);
}

test::KnownScene occlusion() {
  return test::render({{{10, 10, 140, 100}, {0, 0, 1.5f}, facing, {128, 128, 128}},
                       {{60, 40, 30, 30}, {0, 0, 1}, facing, {30, 160, 220}}},
                      camera);
}

test::KnownScene single_pixels() {
  return test::render({{{20, 20, 40, 40}, {0, 0, 1}, facing, {10, 20, 30}},
                       {{60, 30, 1, 1}, {0, 0, 1}, {1, 0, -1}, {250, 240, 230}},
                       {{100, 80, 1, 1}, {0, 0, 2}, facing, {0, 0, 0}},
                       {{100, 81, 1, 1}, {0, 0, 2}, facing, {0, 0, 0}}},
                      camera);
}

test::KnownScene tiny(int width, int height) {
  return test::render({{{0, 0, 1, 1}, {0, 0, 1}, facing, {10, 20, 30}},
                       {{width - 1, height - 1, 1, 1}, {0, 0, 1.005f}, facing, {200, 20, 30}}},
                      test::kinect(width, height));
}

}  // namespace

const std::vector<NamedScene>& scenes() {
  static const std::vector<NamedScene> all{{"convex ridge", faces(1)},
                                           {"concave ridge", faces(-1)},
                                           {"one plane in three patches", faces(0)},
                                           {"textured ridge", with_texture(faces(1))},
                                           {"occlusion", occlusion()},
                                           {"single pixels", single_pixels()},
                                           {"2x1 image", tiny(2, 1)},
                                           {"3x3 image", tiny(3, 3)}};
  return all;
}

test::KnownScene renumbered(const test::KnownScene& known) {
  test::KnownScene scene = known;
  const int count = int(known.surfaces.surfaces.size());
  std::reverse(scene.surfaces.surfaces.begin(), scene.surfaces.surfaces.end());
  scene.surfaces.labels = known.surfaces.labels.clone();
  for (int& label : scene.surfaces.labels)
    if (label > 0) label = count + 1 - label;
  scene.patches.labels = scene.surfaces.labels.clone();
  scene.surfaces.adjacencies = find_adjacencies(scene.frame, scene.surfaces.labels, {});
  return scene;
}

}  // namespace gestalt::conformance
