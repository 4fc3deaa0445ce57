// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/pipeline/surface_modelling.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "gestalt/core/base/error.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

/// Fits the plane z = mean(z), whatever the points: enough to follow the arithmetic of model selection by hand.
class FrontalPlane : public Fitter {
 public:
  explicit FrontalPlane(double parameters) : parameters_(parameters) {}
  double parameter_count() const override { return parameters_; }
  std::shared_ptr<const SurfaceModel> fit(std::span<const Eigen::Vector3f> points) const override {
    float sum = 0;
    for (const Eigen::Vector3f& p : points) sum += p.z();
    return test::exact_plane({0, 0, sum / float(points.size())}, {0, 0, -1});
  }

 private:
  double parameters_;
};

/// A surface that passes through every point, at a price.
class PerfectFitter final : public FrontalPlane {
 public:
  using FrontalPlane::FrontalPlane;
  std::shared_ptr<const SurfaceModel> fit(std::span<const Eigen::Vector3f>) const override {
    struct Perfect final : SurfaceModel {
      std::string type() const override { return "perfect"; }
      Foot foot(const Eigen::Vector3f& p) const override { return {p, {0, 0, -1}}; }
      nlohmann::json to_json() const override { return {{"type", "perfect"}}; }
    };
    return std::make_shared<Perfect>();
  }
};

/// One that takes large patches only, and those perfectly.
class FitterOfLargePatches final : public FrontalPlane {
 public:
  using FrontalPlane::FrontalPlane;
  std::shared_ptr<const SurfaceModel> fit(std::span<const Eigen::Vector3f> points) const override {
    return points.size() < 500 ? nullptr : PerfectFitter(parameter_count()).fit(points);
  }
};

class NoFitter final : public FrontalPlane {
 public:
  using FrontalPlane::FrontalPlane;
  std::shared_ptr<const SurfaceModel> fit(std::span<const Eigen::Vector3f>) const override { return nullptr; }
};

using Fitters = std::vector<std::shared_ptr<const Fitter>>;
Fitters frontal() { return {std::make_shared<FrontalPlane>(12)}; }

/// Two squares of 20 x 20 pixels side by side, the right one farther away by a step.
test::KnownScene step(float height) {
  return test::render(
      {{{100, 100, 20, 20}, {0, 0, 1}, {0, 0, -1}}, {{120, 100, 20, 20}, {0, 0, 1 + height}, {0, 0, -1}}});
}

TEST(SurfaceModelling, LeavesPartsApartThatTheClustererCut) {
  auto scene = test::render({{{100, 100, 20, 20}, {0, 0, 1}, {0, 0, -1}},
                             {{120, 100, 20, 20}, {0, 0, 1}, {0, 0, -1}},
                             {{100, 120, 40, 20}, {0, 0, 1}, {0, 0, -1}}});
  EXPECT_EQ(model_surfaces(scene.frame, scene.patches, frontal(), {}).surfaces.size(), 1U);
  scene.patches.cut_from = {1, 1, 2};  // the third may join one of the two, and then not the other
  const SurfaceSet set = model_surfaces(scene.frame, scene.patches, frontal(), {});
  EXPECT_EQ(set.surfaces.size(), 2U);
  EXPECT_NE(set.labels(110, 110), set.labels(110, 130));
}

TEST(SurfaceModelling, MergesPatchesOfOnePlane) {
  const auto scene = step(0);
  const SurfaceSet set = model_surfaces(scene.frame, scene.patches, frontal(), {});
  ASSERT_EQ(set.surfaces.size(), 1u);
  EXPECT_EQ(set.surfaces[0].pixels.size(), 800u);
  EXPECT_TRUE(std::is_sorted(set.surfaces[0].pixels.begin(), set.surfaces[0].pixels.end()));
  EXPECT_TRUE(set.adjacencies.empty());
}

TEST(SurfaceModelling, KeepsAStepThatOnePlaneDoesNotExplain) {
  const auto scene = step(0.008f);
  const SurfaceSet set = model_surfaces(scene.frame, scene.patches, frontal(), {});
  ASSERT_EQ(set.surfaces.size(), 2u);
  ASSERT_EQ(set.adjacencies.size(), 1u);
  EXPECT_EQ(set.labels(110, 105), 1);
  EXPECT_EQ(set.labels(110, 125), 2);
}

TEST(SurfaceModelling, MergesExactlyWhenTheSavingsGrow) {
  // One plane between two equal patches leaves e = step / 2 at each of the 2n points: merging pays while
  // kappa_1 * 12 > 2 (1 - exp(-e^2 / sigma^2)), with A_m = n.
  SurfaceModellingParams params;
  const double scene_noise = DepthNoise{}.at(1);
  const double e = params.sigma * scene_noise * std::sqrt(-std::log(1 - params.kappa_1 * 12 / 2));
  const auto below = step(float(2 * e * 0.97)), above = step(float(2 * e * 1.03));
  EXPECT_EQ(model_surfaces(below.frame, below.patches, frontal(), params).surfaces.size(), 1u);
  EXPECT_EQ(model_surfaces(above.frame, above.patches, frontal(), params).surfaces.size(), 2u);
}

TEST(SurfaceModelling, NormalisedByTheMergedSizeEqualPatchesMergeUpToTwiceTheError) {
  SurfaceModellingParams params;
  params.normalisation = "merged";
  const double scene_noise = DepthNoise{}.at(1);
  const double e = params.sigma * scene_noise * std::sqrt(-std::log(1 - params.kappa_1 * 12));
  const auto below = step(float(2 * e * 0.97)), above = step(float(2 * e * 1.03));
  EXPECT_EQ(model_surfaces(below.frame, below.patches, frontal(), params).surfaces.size(), 1u);
  EXPECT_EQ(model_surfaces(above.frame, above.patches, frontal(), params).surfaces.size(), 2u);
}

TEST(SurfaceModelling, AfterTheFirstFitterOnlyADearerSurfaceReplacesTwo) {
  const auto scene = step(0);
  SurfaceModellingParams params;
  params.merger_fitters = "after_first";
  const auto count = [&](double parameters) {
    const Fitters both{std::make_shared<FrontalPlane>(12), std::make_shared<PerfectFitter>(parameters)};
    return model_surfaces(scene.frame, scene.patches, both, params).surfaces.size();
  };
  EXPECT_EQ(model_surfaces(scene.frame, scene.patches, frontal(), params).surfaces.size(), 2u);
  EXPECT_EQ(count(23), 1u);  // less than two planes of 12
  EXPECT_EQ(count(25), 2u);
}

TEST(SurfaceModelling, ALargePatchIsMergedByTheFirstFitterAlone) {
  // 1200 and 400 pixels, a step that a plane does not explain.
  const auto scene =
      test::render({{{100, 100, 60, 20}, {0, 0, 1}, {0, 0, -1}}, {{160, 100, 20, 20}, {0, 0, 1.008f}, {0, 0, -1}}});
  const Fitters both{std::make_shared<FrontalPlane>(12), std::make_shared<PerfectFitter>(13)};
  SurfaceModellingParams params;
  params.merger_fitters = "after_first";
  const auto count = [&](double largest) {
    params.largest_solid_angle = largest / (525 * 525);
    return model_surfaces(scene.frame, scene.patches, both, params).surfaces.size();
  };
  EXPECT_EQ(count(1199.5), 2u);
  EXPECT_EQ(count(1200.5), 1u);  // the merged patch may be larger
}

TEST(SurfaceModelling, ATableDoesNotSwallowASmallPatchBesideIt) {
  const auto scene =
      test::render({{{0, 0, 640, 400}, {0, 0, 1}, {0, 0, -1}}, {{300, 200, 10, 10}, {0, 0, 0.992f}, {0, 0, -1}}});
  EXPECT_EQ(model_surfaces(scene.frame, scene.patches, frontal(), {}).surfaces.size(), 2u);
}

TEST(SurfaceModelling, ChoosesTheDearerModelOnlyWhereItPays) {
  // A plane at 45 degrees is explained badly by a frontal one, a frontal patch perfectly.
  const auto scene =
      test::render({{{100, 100, 30, 30}, {0, 0, 1}, {1, 0, -1}}, {{300, 100, 30, 30}, {0, 0, 1}, {0, 0, -1}}});
  const Fitters both{std::make_shared<FrontalPlane>(12), std::make_shared<PerfectFitter>(27)};
  const SurfaceSet set = model_surfaces(scene.frame, scene.patches, both, {});
  ASSERT_EQ(set.surfaces.size(), 2u);
  EXPECT_EQ(set.surfaces[0].model->type(), "perfect");
  EXPECT_EQ(set.surfaces[1].model->type(), "plane");
}

TEST(SurfaceModelling, LeavesALargePatchToTheFirstFitter) {
  const auto scene = test::render({{{100, 100, 30, 30}, {0, 0, 1}, {1, 0, -1}}});
  const Fitters both{std::make_shared<FrontalPlane>(12), std::make_shared<PerfectFitter>(27)};
  SurfaceModellingParams params;
  params.largest_solid_angle = 899.5 / (525 * 525);
  EXPECT_EQ(model_surfaces(scene.frame, scene.patches, both, params).surfaces[0].model->type(), "plane");
}

TEST(SurfaceModelling, FitsAMergedPatchAnewWhereItsPartsHadNoModel) {
  const auto scene = step(0.008f);  // two patches of 400 points, which one frontal plane does not explain
  const Fitters both{std::make_shared<FrontalPlane>(12), std::make_shared<FitterOfLargePatches>(13)};
  const SurfaceSet set = model_surfaces(scene.frame, scene.patches, both, {});
  ASSERT_EQ(set.surfaces.size(), 1u);
  EXPECT_EQ(set.surfaces[0].pixels.size(), 800u);
  EXPECT_EQ(set.surfaces[0].model->type(), "perfect");
}

TEST(SurfaceModelling, NamesTheRemedyWhenNoFitterFits) {
  const auto scene = step(0);
  try {
    model_surfaces(scene.frame, scene.patches, {std::make_shared<NoFitter>(12)}, {});
    FAIL();
  } catch (const PluginError& error) {
    EXPECT_NE(std::string(error.what()).find("primitive.fitters"), std::string::npos);
  }
}

TEST(Adjacencies, AreTheTouchingPixelsOf8Neighbours) {
  const auto scene = step(0.02f);
  const auto adjacencies = find_adjacencies(scene.frame, scene.patches.labels, {});
  ASSERT_EQ(adjacencies.size(), 1u);
  EXPECT_EQ(adjacencies[0].a, 0);
  EXPECT_EQ(adjacencies[0].b, 1);
  EXPECT_EQ(adjacencies[0].border_2d.size(), 20u + 19u + 19u);  // straight across, and both diagonals
  EXPECT_TRUE(adjacencies[0].border_3d.empty());                // 2 cm at 1 m is more than 0.007 z
  for (const PixelPair& p : adjacencies[0].border_2d) {
    EXPECT_EQ(scene.patches.labels(p.a / 640, p.a % 640), 1);
    EXPECT_EQ(scene.patches.labels(p.b / 640, p.b % 640), 2);
  }
}

TEST(Adjacencies, OfASmallStepAreIn3D) {
  const auto scene = step(0.005f);
  const auto adjacencies = find_adjacencies(scene.frame, scene.patches.labels, {});
  EXPECT_EQ(adjacencies.at(0).border_3d.size(), adjacencies.at(0).border_2d.size());
}

TEST(Adjacencies, DoNotCrossPixelsWithoutDepth) {
  const auto scene =
      test::render({{{100, 100, 20, 20}, {0, 0, 1}, {0, 0, -1}}, {{121, 100, 20, 20}, {0, 0, 1}, {0, 0, -1}}});
  EXPECT_TRUE(find_adjacencies(scene.frame, scene.patches.labels, {}).empty());
}

/// Every pixel's neighbours to the right and below, one after another.
std::map<std::pair<int, int>, std::vector<std::pair<int, int>>> touching_plainly(const cv::Mat_<int>& labels) {
  std::map<std::pair<int, int>, std::vector<std::pair<int, int>>> touching;
  const cv::Rect image({}, labels.size());
  for (int p = 0; p < int(labels.total()); ++p) {
    const cv::Point at(p % labels.cols, p / labels.cols);
    for (const cv::Point& step : {cv::Point(1, 0), cv::Point(-1, 1), cv::Point(0, 1), cv::Point(1, 1)}) {
      const cv::Point to = at + step;
      if (!image.contains(to) || labels(at) == labels(to) || labels(at) == 0 || labels(to) == 0) continue;
      const int q = to.y * labels.cols + to.x;
      if (labels(at) < labels(to))
        touching[{labels(at) - 1, labels(to) - 1}].emplace_back(p, q);
      else
        touching[{labels(to) - 1, labels(at) - 1}].emplace_back(q, p);
    }
  }
  return touching;
}

// Blocks of pixels of one label are passed over; what is found is the same.
TEST(Adjacencies, AreThoseOfEveryPixel) {
  cv::RNG random(3);
  for (int run = 0; run < 50; ++run) {
    const cv::Size size(random.uniform(1, 60), random.uniform(1, 40));
    const Frame frame = make_frame("frame", {}, cv::Mat_<float>(size, 1.f),
                                   {size.width, size.height, 525, 525, 0.5 * size.width, 0.5 * size.height});
    cv::Mat_<int> labels(size, 1);
    for (int i = random.uniform(0, 12); i > 0; --i) {
      const cv::Rect patch(random.uniform(0, size.width), random.uniform(0, size.height), random.uniform(1, 20),
                           random.uniform(1, 20));
      labels(patch & cv::Rect({}, size)).setTo(random.uniform(0, 6));
    }
    std::map<std::pair<int, int>, std::vector<std::pair<int, int>>> found;
    for (const Adjacency& adjacency : find_adjacencies(frame, labels, {}))
      for (const PixelPair& pair : adjacency.border_2d) found[{adjacency.a, adjacency.b}].emplace_back(pair.a, pair.b);
    EXPECT_EQ(found, touching_plainly(labels));
  }
}

}  // namespace
}  // namespace gestalt
