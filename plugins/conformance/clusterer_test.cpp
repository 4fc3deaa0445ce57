// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <set>

#include "scenes.h"
#include "subjects.h"

namespace gestalt::conformance {
namespace {

struct NamedFrame {
  std::string name;
  Frame frame;
};

NamedFrame noisy() {
  cv::Mat_<float> depth(120, 160);
  cv::RNG random(1);
  random.fill(depth, cv::RNG::UNIFORM, 0.5, 3.0);
  for (int u = 0; u < 160; ++u) depth(60, u) = 0;
  return {"noise", make_frame("noise", {}, depth, test::kinect(160, 120))};
}

NamedFrame one_pixel(int width, int height) {
  cv::Mat_<float> depth(height, width, 0.f);
  depth(height / 2, width / 2) = 1;
  return {"one valid pixel of " + std::to_string(width) + "x" + std::to_string(height),
          make_frame("pixel", {}, depth, test::kinect(width, height))};
}

/// The scenes of the relations, and what only a sensor gives.
std::vector<NamedFrame> frames() {
  std::vector<NamedFrame> all{noisy(), one_pixel(160, 120), one_pixel(1, 1)};
  for (const NamedScene& scene : scenes()) all.push_back({scene.name, scene.known.frame});
  return all;
}

bool equal(const PatchMap& a, const PatchMap& b) {
  const auto same = [](const cv::Mat& x, const cv::Mat& y) {
    return x.size() == y.size() && cv::countNonZero(x.reshape(1) != y.reshape(1)) == 0;
  };
  return a.count == b.count && same(a.labels, b.labels) && same(a.normals, b.normals);
}

class ClustererContract : public SubjectTest<Clusterer> {};

TEST_P(ClustererContract, UsesEveryLabelAndNoneWithoutDepth) {
  for (const NamedFrame& f : frames()) {
    SCOPED_TRACE(f.name);
    const PatchMap patches = subject_->cluster(f.frame);
    ASSERT_EQ(patches.labels.size(), f.frame.depth.size());
    std::set<int> used;
    for (int i = 0; i < int(patches.labels.total()); ++i) {
      const int label = patches.labels(i);
      ASSERT_TRUE(label == 0 || f.frame.valid(i)) << "pixel " << i << " has no depth";
      if (label != 0) used.insert(label);
    }
    EXPECT_EQ(int(used.size()), patches.count);
    if (!used.empty()) {
      EXPECT_EQ(*used.begin(), 1);
      EXPECT_EQ(*used.rbegin(), patches.count);
    }
  }
}

TEST_P(ClustererContract, NormalsAreUnitAndTowardsTheCamera) {
  for (const NamedFrame& f : frames()) {
    SCOPED_TRACE(f.name);
    const PatchMap patches = subject_->cluster(f.frame);
    ASSERT_EQ(patches.normals.size(), f.frame.depth.size());
    for (int i = 0; i < int(patches.normals.total()); ++i) {
      const cv::Vec3f n = patches.normals(i);
      if (n == cv::Vec3f()) continue;
      ASSERT_NEAR(cv::norm(n), 1, 1e-4) << "pixel " << i;
      ASSERT_TRUE(f.frame.valid(i)) << "pixel " << i << " has a normal but no depth";
      ASSERT_LT(n.dot(f.frame.points(i)), 0) << "pixel " << i;
    }
  }
}

TEST_P(ClustererContract, KeepsTheWallApartFromWhatStandsBeforeIt) {
  const test::KnownScene known = test::rectangle_before_wall();
  const PatchMap patches = subject_->cluster(known.frame);
  const int rectangle = patches.labels(240, 320), wall = patches.labels(140, 150);
  EXPECT_NE(rectangle, 0);
  EXPECT_NE(wall, 0);
  EXPECT_NE(rectangle, wall);
}

TEST_P(ClustererContract, GivesTheSameTwiceAndForAnyNumberOfThreads) {
  for (const NamedFrame& f : frames()) {
    SCOPED_TRACE(f.name);
    const auto run = [&] { return subject_->cluster(f.frame); };
    const PatchMap one = with_threads(1, run);
    EXPECT_TRUE(equal(with_threads(1, run), one));
    EXPECT_TRUE(equal(with_threads(8, run), one));
  }
}

GESTALT_CONFORMANCE(ClustererContract, "clusterer");

}  // namespace
}  // namespace gestalt::conformance
