#include "my_component.h"

#include <gestalt/tests/scenes/test_scenes.h>
#include <gtest/gtest.h>

namespace {

/// The relation's value for two patches of these grey values, side by side.
double value(uchar left, uchar right, const MyComponent::Params& params = {}) {
  const Eigen::Vector3f point(0, 0, 1), normal(0, 0, -1);
  const gestalt::test::KnownScene known = gestalt::test::render(
      {{{0, 0, 40, 40}, point, normal, cv::Vec3b::all(left)}, {{40, 0, 40, 40}, point, normal, cv::Vec3b::all(right)}});
  const gestalt::Scene scene(known.frame, known.patches, known.surfaces);
  double value = -1;
  (*MyComponent(params).bind(scene))({0, 1, nullptr}, {&value, 1});
  return value;
}

TEST(MyComponent, IsTheDifferenceOfTheMeans) { EXPECT_NEAR(value(51, 102), 0.2, 1e-9); }

TEST(MyComponent, IsNothingForEqualPatches) { EXPECT_EQ(value(80, 80), 0); }

TEST(MyComponent, CountsNoDifferenceBeyondOne) { EXPECT_EQ(value(0, 255, {.contrast = 3}), 1); }

}  // namespace
