#include "my_component.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

using Points = std::vector<Eigen::Vector3f>;

TEST(MyComponent, LiesInTheMiddleOfNoisyPoints) {
  Points points;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j)
      points.emplace_back(0.01f * float(i), 0.01f * float(j), (i + j) % 2 == 0 ? 1.001f : 0.999f);
  const auto foot = MyComponent({}).fit(points)->foot({0.1f, 0.1f, 1.02f});
  EXPECT_LT((foot.point - Eigen::Vector3f(0.1f, 0.1f, 1)).norm(), 1e-4f);
  EXPECT_LT(foot.normal.z(), -0.999f);
}

TEST(MyComponent, TellsWhyItRefuses) {
  const MyComponent fitter({});
  const Points line{{0, 0, 1}, {0.01f, 0, 1}, {0.02f, 0, 1}};
  EXPECT_EQ(fitter.fit(line), nullptr);
  EXPECT_EQ(fitter.refusal(line), "collinear points");
  EXPECT_EQ(fitter.refusal({}), "fewer than 3 points");
}

}  // namespace
