// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// What was rewritten for speed, beside the plainest way to say the same.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "gestalt/synthesis/synthesis.h"
#include "least_squares_normal.h"
#include "patch_growing.h"
#include "patch_refinement.h"
#include "pixel_grid.h"
#include "running_plane.h"
#include "tolerance_memory.h"

namespace gestalt {
namespace {

using Moments = NeighbourMoments<float>;

void add_neighbour(Moments& m, const Eigen::Vector3f& d) {
  m.n += 1;
  m.x += d.x(), m.y += d.y(), m.w += d.z();
  m.xx += d.x() * d.x(), m.xy += d.x() * d.y(), m.xw += d.x() * d.z();
  m.yy += d.y() * d.y(), m.yw += d.y() * d.z(), m.ww += d.z() * d.z();
}

LeastSquaresNormal<float> normal_of(const Moments& m, const Vector<float>& point) {
  LeastSquaresNormal<float> normal;
  find_normal(m, point, normal);
  return normal;
}

struct EigenNormal {
  Eigen::Vector3d normal;
  Eigen::Vector3d eigenvalues;  // ascending, sum 1
};

EigenNormal by_eigen(const Moments& m, const Vector<float>& point) {
  const Eigen::Vector3d sum(m.x, m.y, m.w);
  Eigen::Matrix3d second;
  second << m.xx, m.xy, m.xw, m.xy, m.yy, m.yw, m.xw, m.yw, m.ww;
  const Eigen::Matrix3d covariance = second - sum * sum.transpose() / double(m.n);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance / covariance.trace());
  Eigen::Vector3d normal = solver.eigenvectors().col(0);
  if (normal.dot(Eigen::Vector3d(point.x, point.y, point.z)) > 0) normal = -normal;
  return {normal, solver.eigenvalues()};
}

/// Neighbours on planes of any slope with noise from none to as much as the window is wide.
struct RandomNeighbourhoods {
  std::mt19937 random{11};
  std::normal_distribution<float> gauss{};
  Vector<float> point;

  Moments next() {
    const Eigen::Vector3f normal = Eigen::Vector3f(gauss(random), gauss(random), gauss(random)).normalized();
    const float noise = 0.003f * std::exp2(-float(random() % 12));
    const Eigen::Vector3f p = Eigen::Vector3f(0.3f * gauss(random), 0.3f * gauss(random), 1);
    point = {p.x(), p.y(), p.z()};
    Moments m;
    const int count = 3 + int(random() % 46);
    for (int i = 0; i < count; ++i) {
      Eigen::Vector3f d = 0.003f * Eigen::Vector3f(gauss(random), gauss(random), gauss(random));
      d += (noise * gauss(random) - normal.dot(d)) * normal;
      add_neighbour(m, d);
    }
    return m;
  }
};

TEST(LeastSquaresNormal, IsThatOfAnEigenvalueSolver) {
  RandomNeighbourhoods neighbourhoods;
  int compared = 0;
  for (int i = 0; i < 20000; ++i) {
    const Moments m = neighbourhoods.next();
    const LeastSquaresNormal<float> own = normal_of(m, neighbourhoods.point);
    const EigenNormal reference = by_eigen(m, neighbourhoods.point);
    const Eigen::Vector3d ray(neighbourhoods.point.x, neighbourhoods.point.y, neighbourhoods.point.z);
    if (std::abs(reference.normal.dot(ray)) < 1e-3) continue;
    EXPECT_NEAR(own.curvature, reference.eigenvalues[0], 1e-4) << i;
    // The fewer digits separate two eigenvalues, the fewer digits their vectors have.
    const double gap = reference.eigenvalues[1] - reference.eigenvalues[0];
    if (gap < 1e-3) continue;
    ++compared;
    const Eigen::Vector3d normal(own.x, own.y, own.z);
    EXPECT_NEAR(normal.norm(), 1, 1e-5) << i;
    EXPECT_LT((normal - reference.normal).norm(), 2e-5 / gap) << i;
  }
  EXPECT_GT(compared, 19000);
}

TEST(LeastSquaresNormal, OfLanesAreThoseOfEachPixel) {
  RandomNeighbourhoods neighbourhoods;
  for (int i = 0; i < 2000; ++i) {
    NeighbourMoments<WideFloats> together;
    Vector<WideFloats> points;
    std::array<LeastSquaresNormal<float>, wide_lanes> alone;
    for (int k = 0; k < wide_lanes; ++k) {
      const Moments m = k == i % 16 ? Moments{} : neighbourhoods.next();
      const Vector<float> p = neighbourhoods.point;
      together.n[k] = m.n;
      together.x[k] = m.x, together.y[k] = m.y, together.w[k] = m.w;
      together.xx[k] = m.xx, together.xy[k] = m.xy, together.xw[k] = m.xw;
      together.yy[k] = m.yy, together.yw[k] = m.yw, together.ww[k] = m.ww;
      points.x[k] = p.x, points.y[k] = p.y, points.z[k] = p.z;
      alone[std::size_t(k)] = normal_of(m, p);
    }
    LeastSquaresNormal<WideFloats> lanes;
    find_normal(together, points, lanes);
    for (int k = 0; k < wide_lanes; ++k) {
      const LeastSquaresNormal<float>& own = alone[std::size_t(k)];
      EXPECT_EQ((std::array<float, 4>{lanes.x[k], lanes.y[k], lanes.z[k], lanes.curvature[k]}),
                (std::array<float, 4>{own.x, own.y, own.z, own.curvature}));
    }
  }
}

TEST(LeastSquaresNormal, IsZeroWhereThereIsNoPlane) {
  const Vector<float> point{0, 0, 1};
  Moments two, same, line, edge_on;
  for (int i = 0; i < 9; ++i) {
    const auto t = float(i - 4) / 1024, s = float(i % 3) / 1024;
    if (i < 2) add_neighbour(two, {t, s, 0});
    add_neighbour(same, {0, 0, 0});
    add_neighbour(line, {t, 0, 0});
    add_neighbour(edge_on, {0, t, s});
  }
  for (const Moments& m : {Moments{}, two, same, line, edge_on}) {
    const LeastSquaresNormal<float> n = normal_of(m, point);
    EXPECT_EQ((std::array{n.x, n.y, n.z, n.curvature}), (std::array{0.f, 0.f, 0.f, 1.f}));
  }
}

TEST(ToleranceMemory, GivesTheTolerances) {
  Frame frame;
  frame.camera = {640, 480, 525, 525, 320, 240};
  const Tolerances tolerances(frame, {});
  ToleranceMemory memory(tolerances);
  std::mt19937 random(3);
  std::vector<float> depths(20000);
  for (float& z : depths) z = 0.3f + 5 * float(random()) / float(std::mt19937::max());
  for (int round = 0; round < 2; ++round)
    for (const float z : depths) {
      EXPECT_EQ(memory.distance(z), tolerances.distance(z));
      EXPECT_EQ(memory.cosine(z), tolerances.cosine(z));
    }
}

/// Patches as Section 3 has it: the plane is the mean of all pixels so far, at every pixel; from the same seeds.
cv::Mat_<int> grow_plainly(const Frame& frame, const NormalMap& normals, const Tolerances& tolerances) {
  const PixelGrid grid(frame, normals);
  cv::Mat_<int> labels(frame.depth.size(), 0);
  int* label = labels.ptr<int>();
  std::vector<int> seeds;
  for (int p = 0; p < grid.size(); ++p)
    if (grid.has_normal(p)) seeds.push_back(p);
  std::stable_sort(seeds.begin(), seeds.end(),
                   [&](int a, int b) { return normals.curvature.ptr<float>()[a] < normals.curvature.ptr<float>()[b]; });
  int count = 0;
  for (const int seed : seeds) {
    if (label[seed] != 0) continue;
    RunningPlane plane;
    std::vector<int> patch;
    const auto take = [&](int p) {
      label[p] = count;
      patch.push_back(p);
      plane.sum(grid.point(p), grid.normal(p));
      plane.update();
    };
    ++count;
    take(seed);
    for (int round = 0; round < 2; ++round)
      for (std::size_t i = 0; i < patch.size(); ++i)
        grid.for_neighbours_4(patch[i], [&](int q) {
          if (label[q] != 0 || !grid.has_normal(q)) return;
          const Eigen::Vector3f p = grid.point(q);
          if (plane.distance(p) <= tolerances.distance(p.z()) &&
              grid.normal(q).dot(plane.normal) >= tolerances.cosine(p.z()))
            take(q);
        });
    if (int(patch.size()) >= tolerances.min_patch_size()) continue;
    for (const int p : patch) label[p] = 0;
  }
  return labels;
}

/// Share of the pixels in patches of one labelling that are, in the other, of the patch most of theirs are of.
double agreement(const cv::Mat_<int>& labels, const cv::Mat_<int>& other) {
  std::map<int, std::map<int, int>> shared;
  for (int p = 0; p < int(labels.total()); ++p) ++shared[labels.ptr<int>()[p]][other.ptr<int>()[p]];
  shared.erase(0);
  double most = 0, all = 0;
  for (const auto& [label, counts] : shared) {
    int best = 0;
    for (const auto& [partner, count] : counts) {
      best = std::max(best, count);
      all += count;
    }
    most += best;
  }
  return most / all;
}

// The plane of a patch is updated only when a 1024th of its pixels was added, and seeds of nearly the same curvature
// come in any order: few pixels of a frame are in another patch for that.
TEST(PatchGrowing, IsThatOfAPlaneTakenAnewAtEveryPixel) {
  for (const Category category : {Category::stacked_boxes, Category::complex_scene}) {
    const Frame frame = synthesize(category, 5, 0).frame;
    const Tolerances tolerances(frame, {});
    const NormalMap normals = estimate_normals(frame, tolerances);
    const LabelledPatches own = grow_patches(frame, normals, tolerances);
    const cv::Mat_<int> plain = grow_plainly(frame, normals, tolerances);
    EXPECT_GT(agreement(own.labels, plain), 0.98);
    EXPECT_GT(agreement(plain, own.labels), 0.98);
  }
}

// Dilating the cores is painting a square around each: squares are of one patch, so none paints over another's.
TEST(PatchRefinement, CutsWhatNoSquareOfItsPatchReaches) {
  const Frame frame = synthesize(Category::complex_scene, 5, 1).frame;
  ToleranceParams only_spurs;  // nothing that is cut finds a new patch
  only_spurs.spur_distance = 0;
  const Tolerances tolerances(frame, only_spurs);
  const NormalMap normals = estimate_normals(frame, tolerances);
  const LabelledPatches grown = grow_patches(frame, normals, tolerances);
  const cv::Mat_<int>& labels = grown.labels;
  const int radius = tolerances.spur_radius();
  cv::Mat_<int> expected(labels.size(), 0);
  for (int v = radius; v < labels.rows - radius; ++v)
    for (int u = radius; u < labels.cols - radius; ++u) {
      const cv::Rect square(u - radius, v - radius, 2 * radius + 1, 2 * radius + 1);
      if (cv::countNonZero(labels(square) != labels(v, u)) == 0) expected(square) = labels(v, u);
    }
  const LabelledPatches tidied = tidy_outlines(frame, normals, tolerances, {labels.clone(), grown.count});
  EXPECT_EQ(cv::countNonZero(tidied.labels != expected), 0);
  EXPECT_GT(cv::countNonZero(labels != expected), 100);
}

// With the focal length of a telescope a spur is wider than the image.
TEST(PatchRefinement, CutsAllWhereNoSquareFits) {
  const Frame kinect = synthesize(Category::complex_scene, 5, 1).frame;
  for (const double focal : {525.0, 525.0 * 119, 525.0 * 120, 525.0 * 1e6}) {
    Camera camera = kinect.camera;
    camera.fx = camera.fy = focal;
    Frame frame = kinect;
    frame.camera = camera;
    const Tolerances tolerances(frame, {});
    const NormalMap normals{cv::Mat_<cv::Vec3f>(frame.depth.size(), cv::Vec3f(0, 0, -1)), {}};
    const LabelledPatches one{cv::Mat_<int>(frame.depth.size(), 1), 1};
    const cv::Mat_<int> tidied = tidy_outlines(frame, normals, tolerances, one).labels;
    EXPECT_EQ(cv::countNonZero(tidied), focal < 525 * 120 ? int(tidied.total()) : 0) << focal;
  }
}

}  // namespace
}  // namespace gestalt
