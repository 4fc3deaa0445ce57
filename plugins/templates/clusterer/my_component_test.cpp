#include "my_component.h"

#include <gestalt/tests/scenes/test_scenes.h>
#include <gtest/gtest.h>

namespace {

int label(const gestalt::Frame& frame, int v, int u, const MyComponent::Params& params = {}) {
  return MyComponent(params).cluster(frame).labels(v, u);
}

TEST(MyComponent, SeparatesWhatStandsBeforeTheWall) {
  const gestalt::Frame frame = gestalt::test::rectangle_before_wall().frame;
  EXPECT_NE(label(frame, 240, 320), label(frame, 140, 150));
}

TEST(MyComponent, SeparatesTheFacesOfABoxUnlessTheAngleIsLarge) {
  const gestalt::Frame frame = gestalt::test::ridge(true).frame;  // its faces meet at 90 degrees in column 320
  EXPECT_NE(label(frame, 240, 300), label(frame, 240, 340));
  EXPECT_EQ(label(frame, 240, 300, {.angle = 1.6}), label(frame, 240, 340, {.angle = 1.6}));
}

TEST(MyComponent, FollowsASlantWithItsNormals) {
  const auto known = gestalt::test::render({{{200, 200, 50, 50}, {0, 0, 1}, {0, -0.6f, -0.8f}}});
  const gestalt::PatchMap patches = MyComponent({}).cluster(known.frame);
  EXPECT_EQ(patches.count, 1);
  EXPECT_LT(cv::norm(patches.normals(220, 220) - cv::Vec3f(0, -0.6f, -0.8f)), 0.01);
}

}  // namespace
