// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/objects/object_description.h"

#include <gtest/gtest.h>

#include <memory>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

/// A wall 1.5 m away, and a rectangle 1 m away in front of it, which is the only object.
SegmentedFrame rectangle() {
  test::KnownScene known = test::rectangle_before_wall();
  SegmentedFrame found;
  const int pixels[] = {int(known.surfaces.surfaces[0].pixels.size()), int(known.surfaces.surfaces[1].pixels.size())};
  found.segmentation.segments = {{{0}, pixels[0], Role::background}, {{1}, pixels[1], Role::object}};
  found.segmentation.graph.sizes = {pixels[0], pixels[1]};
  found.percept.roles = {Role::background, Role::object};
  found.percept.scene = std::make_shared<Scene>(known.frame, known.patches, known.surfaces);
  return found;
}

TEST(ObjectDescription, TellsWhereAndHowLargeAnObjectIs) {
  const SegmentedFrame found = rectangle();
  const std::vector<ObjectDescription> objects = describe_objects(found);
  ASSERT_EQ(objects.size(), 1u);
  const ObjectDescription& object = objects[0];
  EXPECT_EQ(object.label, 2);
  const Frame& frame = found.percept.frame();
  const std::vector<int>& pixels = found.percept.surfaces().surfaces[1].pixels;
  EXPECT_EQ(object.pixels, int(pixels.size()));
  EXPECT_EQ(object.box.area(), int(pixels.size()));  // it is a rectangle
  EXPECT_TRUE(object.box.contains({pixels.front() % frame.width(), pixels.front() / frame.width()}));
  EXPECT_NEAR(object.centroid.z(), 1, 1e-3);
  const double width = (object.box.width - 1) / frame.camera.fx, height = (object.box.height - 1) / frame.camera.fy;
  EXPECT_NEAR(object.oriented_box.size.x(), std::max(width, height), 0.02 * width);
  EXPECT_NEAR(object.oriented_box.size.y(), std::min(width, height), 0.02 * width);
  EXPECT_NEAR(object.oriented_box.size.z(), 0, 1e-3);
}

TEST(ObjectDescription, TellsWhatIsBehindItAndTheFaceThatIsSeen) {
  const ObjectDescription object = describe_objects(rectangle()).at(0);
  ASSERT_TRUE(object.support);
  EXPECT_EQ(object.support->patch, 0);
  EXPECT_NEAR(object.support->normal.z(), -1, 1e-6);
  EXPECT_NEAR(object.support->offset, -1.5, 1e-4);
  EXPECT_NEAR(object.support->bottom, 0.5, 1e-3);
  EXPECT_NEAR(object.support->top, 0.5, 1e-3);
  EXPECT_EQ(object.kind, ShapeKind::box);  // it is not on the wall
  ASSERT_TRUE(object.largest_face);
  EXPECT_NEAR(object.largest_face->normal.z(), -1, 1e-6);
  EXPECT_NEAR(object.largest_face->area, double(object.pixels) / (525.0 * 525.0), 0.01 * object.largest_face->area);
}

TEST(ObjectDescription, ColourIsRedGreenBlueAndMissingWithoutColour) {
  SegmentedFrame found = rectangle();
  Frame frame = found.percept.frame();
  frame.colour = cv::Mat(frame.depth.size(), CV_8UC3, cv::Scalar(10, 20, 200));
  found.percept.scene = std::make_shared<Scene>(frame, found.percept.patches(), found.percept.surfaces());
  const ObjectDescription object = describe_objects(found).at(0);
  ASSERT_TRUE(object.colour);
  EXPECT_NEAR((object.colour->mean - Eigen::Vector3d(200, 20, 10)).norm(), 0, 1e-9);
  EXPECT_NEAR(object.colour->deviation.norm(), 0, 1e-9);
  frame.colour = cv::Mat();
  found.percept.scene = std::make_shared<Scene>(frame, found.percept.patches(), found.percept.surfaces());
  EXPECT_FALSE(describe_objects(found).at(0).colour);
}

TEST(ObjectDescription, WithoutBackgroundThereIsNoSupport) {
  SegmentedFrame found = rectangle();
  found.percept.roles = {Role::object, Role::object};
  found.segmentation.segments[0].role = Role::object;
  const std::vector<ObjectDescription> objects = describe_objects(found);
  ASSERT_EQ(objects.size(), 2u);
  for (const ObjectDescription& object : objects) {
    EXPECT_FALSE(object.support);
    EXPECT_EQ(object.kind, ShapeKind::plane);
    EXPECT_NEAR(std::abs(object.oriented_box.axes(2, 2)), 1, 1e-6);
  }
}

}  // namespace
}  // namespace gestalt
