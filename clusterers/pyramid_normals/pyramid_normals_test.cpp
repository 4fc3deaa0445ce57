// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "pyramid_normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "gestalt/synthesis/synthesis.h"
#include "gestalt/tests/scenes/test_scenes.h"
#include "half_resolution.h"

namespace gestalt {
namespace {

Tolerances tolerances_of(const Frame& frame) { return {frame, {}}; }

Frame frame_of(const cv::Mat_<float>& depth) {
  return make_frame("frame", {}, depth, {depth.cols, depth.rows, 525, 525, 0.5 * depth.cols, 0.5 * depth.rows});
}

int label_at(const PatchMap& map, int u, int v) { return map.labels(v, u); }

/// Distinct labels of the pixels, without 0.
std::set<int> labels_of(const cv::Mat_<int>& labels) {
  std::set<int> distinct(labels.begin(), labels.end());
  distinct.erase(0);
  return distinct;
}

float angle_to(const cv::Vec3f& a, const cv::Vec3f& b) { return std::acos(std::clamp(a.dot(b), -1.f, 1.f)); }

TEST(Halve, IsTheMeanOfWhatIsMeasured) {
  const Frame frame = frame_of((cv::Mat_<float>(2, 4) << 1.f, 1.002f, 0, 0, 1.004f, 1.006f, 2.f, 0));
  const Frame half = halve(frame, tolerances_of(frame));
  ASSERT_EQ(half.depth.size(), cv::Size(2, 1));
  EXPECT_FLOAT_EQ(half.depth(0, 0), 1.003f);
  EXPECT_FLOAT_EQ(half.depth(0, 1), 2);
}

TEST(Halve, DoesNotAverageAcrossADepthJump) {
  const Frame frame = frame_of((cv::Mat_<float>(2, 4) << 1, 2, 2, 1, 1, 1, 2, 1));
  const Frame half = halve(frame, tolerances_of(frame));
  EXPECT_FLOAT_EQ(half.depth(0, 0), 1);  // three of four
  EXPECT_FLOAT_EQ(half.depth(0, 1), 1);  // two of four: the nearer side
}

TEST(Halve, SeesThePlaneThatTheFrameSees) {
  const Frame frame = test::ridge(true).frame, half = halve(frame, tolerances_of(frame));
  EXPECT_EQ(half.depth.size(), cv::Size(320, 240));
  // On the left face of the ridge x + z is the same everywhere.
  const auto offset = [](const cv::Vec3f& p) { return p[0] + p[2]; };
  const float expected = offset(frame.points(240, 270));
  EXPECT_NEAR(offset(half.points(120, 135)), expected, 1e-4);
  EXPECT_NEAR(offset(half.points(130, 150)), expected, 1e-4);
}

TEST(Halve, RoundsOddSizesUp) {
  const Frame frame = frame_of(cv::Mat_<float>(3, 1, 1.f));
  EXPECT_EQ(halve(frame, tolerances_of(frame)).depth.size(), cv::Size(1, 2));
}

TEST(Reorganisation, BringsNormalsBesideARidgeToTheirOwnSide) {
  const Frame frame = test::ridge(true).frame;
  const Tolerances tolerances = tolerances_of(frame);
  const NormalMap plain = estimate_normals(frame, tolerances), better = reorganise(frame, plain, tolerances, {});
  const float s = std::sqrt(0.5f);
  const cv::Vec3f left(-s, 0, -s), right(s, 0, -s);
  // The ridge is at column 319.5; a normal just on it is like neither side and stays.
  EXPECT_LT(angle_to(better.normals(240, 317), left), 0.8f * angle_to(plain.normals(240, 317), left));
  EXPECT_LT(angle_to(better.normals(240, 322), right), 0.8f * angle_to(plain.normals(240, 322), right));
  EXPECT_LT(angle_to(better.normals(240, 270), left), 2e-3f);
}

TEST(Reorganisation, KeepsNormalsUnitAndMissingOnesMissing) {
  const Frame frame = test::rectangle_before_wall().frame;
  const Tolerances tolerances = tolerances_of(frame);
  const NormalMap plain = estimate_normals(frame, tolerances), better = reorganise(frame, plain, tolerances, {});
  for (int p = 0; p < int(frame.depth.total()); ++p) {
    const cv::Vec3f& n = better.normals.ptr<cv::Vec3f>()[p];
    if (plain.curvature.ptr<float>()[p] < 1)
      ASSERT_NEAR(n.dot(n), 1, 1e-4);
    else
      ASSERT_EQ(n, cv::Vec3f());
  }
}

/// reorganise() said plainly, pixel after pixel.
cv::Mat_<cv::Vec3f> reorganise_plainly(const Frame& frame, const NormalMap& map, const Tolerances& tolerances,
                                       const ReorganisationParams& params) {
  const cv::Rect image({}, frame.depth.size());
  const int radius = params.reorganisation_radius, side = 2 * radius + 1;
  const auto alpha = float(params.neighbour_weight), beta = float(params.likeness);
  const auto squared = [](const cv::Vec3f& d) { return d.dot(d); };
  cv::Mat_<cv::Vec3f> current = map.normals.clone();
  bool moved = true;
  for (int round = 0; round < params.rounds && moved; ++round) {
    cv::Mat_<cv::Vec3f> next = current.clone();
    moved = false;
    for (int i = 0; i < int(current.total()); ++i) {
      const cv::Point p(i % frame.width(), i / frame.width());
      if (!(map.curvature(p) < 1)) continue;
      const float reach = tolerances.squared_reach(frame.depth(p));
      cv::Vec3f sum;
      for (int j = 0; j < side * side; ++j) {
        const cv::Point d(j % side - radius, j / side - radius), q = p + d;
        if (d == cv::Point() || !image.contains(q) || !(map.curvature(q) < 1)) continue;
        if (squared(frame.points(q) - frame.points(p)) > reach * float(d.dot(d))) continue;
        const float like = beta / (squared(current(p) - current(q)) + beta);
        sum += like * like * current(q);
      }
      const cv::Vec3f pulled = map.normals(p) + alpha * sum;
      if (pulled.dot(frame.points(p)) < 0) next(p) = pulled / std::sqrt(pulled.dot(pulled));
      if (squared(next(p) - current(p)) > 1e-6f) moved = true;
    }
    current = next;
  }
  return current;
}

// Lanes sum in another order than OpenCV's dot products do; a pixel whose normal lies between two sides may fall to the
// other one for that.
TEST(Reorganisation, IsThePlainOne) {
  const Frame frame = synthesize(Category::complex_scene, 5, 2).frame;
  const Tolerances tolerances = tolerances_of(frame);
  const NormalMap map = estimate_normals(frame, tolerances);
  const cv::Mat_<cv::Vec3f> plain = reorganise_plainly(frame, map, tolerances, {});
  const NormalMap own = reorganise(frame, map, tolerances, {});
  int others = 0;
  for (int p = 0; p < int(plain.total()); ++p)
    others += cv::norm(own.normals.ptr<cv::Vec3f>()[p] - plain.ptr<cv::Vec3f>()[p]) > 1e-4;
  EXPECT_LT(others, 1e-3 * double(plain.total()));
  EXPECT_EQ(cv::countNonZero(own.curvature != map.curvature), 0);
}

/// A wall 1 m away whose right half is further by a step, with its patches by a rule for each pixel; the camera is one
/// of 64x64 pixels, or that at another resolution.
template <class Rule>
PyramidLevel wall_level(int side, int count, float step, Rule label) {
  cv::Mat_<float> depth(side, side, 1.f);
  LabelledPatches patches{cv::Mat_<int>(side, side), count};
  for (int v = 0; v < side; ++v)
    for (int u = 0; u < side; ++u) {
      if (u >= side / 2) depth(v, u) += step;
      patches.labels(v, u) = label(u);
    }
  const double focal_length = 525. * side / 64, centre = 0.5 * (side - 1);
  Frame frame = make_frame("wall", {}, depth, {side, side, focal_length, focal_length, centre, centre});
  const Tolerances tolerances = tolerances_of(frame);
  NormalMap normals = estimate_normals(frame, tolerances);
  return {std::move(frame), std::move(normals), tolerances, std::move(patches)};
}

int whole(int) { return 1; }
int halves(int u) { return u < 32 ? 1 : 2; }

TEST(LevelSelection, KeepsACoarsePatchThatDescribesAWallInOne) {
  const LabelledPatches chosen = select_patches(wall_level(32, 1, 0, whole), wall_level(64, 2, 0, halves), {});
  EXPECT_EQ(labels_of(chosen.labels), std::set<int>{1});
  EXPECT_EQ(cv::countNonZero(chosen.labels), 64 * 64);
}

TEST(LevelSelection, ReplacesACoarsePatchOverAStepByTheFinePatches) {
  const float step = 0.01f;
  const PyramidLevel coarse = wall_level(32, 1, step, whole), fine = wall_level(64, 2, step, halves);
  const LabelledPatches chosen = select_patches(coarse, fine, {});
  EXPECT_EQ(labels_of(chosen.labels).size(), 2u);
  EXPECT_NE(chosen.labels(32, 8), chosen.labels(32, 56));
  // Where a patch costs more than the error of one for both, the coarse one stays.
  SelectionParams dear;
  dear.kappa_1 = 0.5;
  EXPECT_EQ(labels_of(select_patches(coarse, fine, dear).labels), std::set<int>{1});
}

TEST(LevelSelection, KeepsFinePatchesWhereTheCoarseLevelHasNone) {
  const auto left = [](int u) { return u < 16 ? 1 : 0; };
  const auto right = [](int u) { return u < 32 ? 0 : 1; };
  const LabelledPatches chosen = select_patches(wall_level(32, 1, 0.05f, left), wall_level(64, 1, 0.05f, right), {});
  EXPECT_NE(chosen.labels(32, 8), chosen.labels(32, 56));
  EXPECT_EQ(cv::countNonZero(chosen.labels), 64 * 64);
}

TEST(PyramidNormals, CutsARidgeInTwoPatches) {
  const PatchMap map = PyramidNormals({}).cluster(test::ridge(true).frame);
  EXPECT_EQ(map.count, 2);
  EXPECT_NE(label_at(map, 240, 240), label_at(map, 400, 240));
  EXPECT_EQ(label_at(map, 0, 0), 0);
  // Just beside the ridge too, for all that the coarsest pixels are four wide.
  for (int v = 160; v < 320; ++v) {
    EXPECT_EQ(label_at(map, 317, v), label_at(map, 240, 240));
    EXPECT_EQ(label_at(map, 322, v), label_at(map, 400, 240));
  }
}

TEST(PyramidNormals, CutsAStepInParallelPlanesAtThePixel) {
  const auto scene = test::rectangle_before_wall();
  const PatchMap map = PyramidNormals({}).cluster(scene.frame);
  EXPECT_EQ(map.count, 2);
  int wrong = 0;
  for (int p = 0; p < int(map.labels.total()); ++p)
    wrong += (map.labels.ptr<int>()[p] == label_at(map, 320, 240)) != (scene.surfaces.labels.ptr<int>()[p] == 2);
  EXPECT_EQ(wrong, 0);
}

TEST(PyramidNormals, FindsOneWallInNoiseThatBreaksOneLevel) {
  std::mt19937 random(5);
  std::normal_distribution<float> noise(0, 0.006f);
  cv::Mat_<float> depth(240, 320);
  for (float& z : depth) z = 1 + noise(random);
  const Frame frame = make_frame("noisy", {}, depth, test::kinect(320, 240));  // three times its sensor's noise
  PyramidNormals::Params one_level;
  one_level.levels = 1;
  const PatchMap single = PyramidNormals(one_level).cluster(frame), pyramid = PyramidNormals({}).cluster(frame);
  EXPECT_LT(pyramid.count, single.count);
}

TEST(PyramidNormals, TakesImagesSmallerThanItsCoarsestPixel) {
  PyramidNormals::Params all;
  all.smallest_island = 0;
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(7, 1), cv::Size(1, 5), cv::Size(3, 3)}) {
    const PatchMap map = PyramidNormals(all).cluster(frame_of(cv::Mat_<float>(size, 1.f)));
    EXPECT_EQ(map.count, 1) << size;
    EXPECT_EQ(cv::countNonZero(map.labels), size.area()) << size;
  }
}

}  // namespace
}  // namespace gestalt
