// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Clusterers, fitters and relations on hostile frames and patches.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "gestalt/core/base/error.h"
#include "gestalt/core/pipeline/surface_modelling.h"
#include "gestalt/core/plugin/clusterer.h"
#include "gestalt/core/plugin/fitter.h"
#include "gestalt/core/plugin/relation.h"
#include "hostile_scene.h"

namespace gestalt::properties {
namespace {

TEST(Clusterers, GivePatchesOfPixelsWithDepth) {
  for_each_case([](Chance& chance) {
    const Frame frame = hostile_frame(chance);
    for (const std::string& name : registry().names("clusterer")) {
      SCOPED_TRACE(name);
      const PatchMap patches = any_component<Clusterer>(chance, name)->cluster(frame);
      ASSERT_EQ(patches.labels.size(), frame.depth.size());
      ASSERT_EQ(patches.normals.size(), frame.depth.size());
      std::vector<int> sizes(std::size_t(patches.count) + 1);
      for (int v = 0; v < frame.height(); ++v)
        for (int u = 0; u < frame.width(); ++u) {
          const int label = patches.labels(v, u);
          ASSERT_TRUE(label >= 0 && label <= patches.count) << label;
          ++sizes[std::size_t(label)];
          EXPECT_TRUE(label == 0 || frame.depth(v, u) > 0);
          const cv::Vec3f& n = patches.normals(v, u);
          EXPECT_TRUE(n == cv::Vec3f(0, 0, 0) || std::abs(cv::norm(n) - 1) < 1e-3) << n;
        }
      EXPECT_EQ(std::count(sizes.begin() + 1, sizes.end(), 0), 0) << "a label without a pixel";
    }
  });
}

/// A few points: in front of the camera or anywhere, apart, coincident, collinear or coplanar.
std::vector<Eigen::Vector3f> any_points(Chance& chance) {
  const int dimensions = chance.whole(0, 3);
  const double scale = chance.one_of(std::vector<double>{1e-6, 1e-3, 1, 1000});
  const auto any = [&] { return Eigen::Vector3d(chance.real(-1, 1), chance.real(-1, 1), chance.real(-1, 1)); };
  const Eigen::Vector3d centre = Eigen::Vector3d(0, 0, 1.5 * scale) + scale * any() / 4;
  const Eigen::Vector3d axes[3] = {any(), any(), any()};
  std::vector<Eigen::Vector3f> points;
  for (int i = chance.whole(1, 60); i > 0; --i) {
    Eigen::Vector3d point = centre;
    for (int axis = 0; axis < dimensions; ++axis) point += scale * chance.real(-0.3, 0.3) * axes[axis];
    points.push_back(point.cast<float>());
  }
  return points;
}

bool all_finite(const nlohmann::json& json) {
  if (json.is_structured()) return std::all_of(json.begin(), json.end(), all_finite);
  return !json.is_number_float() || std::isfinite(json.get<double>());
}

void expect_sound(const SurfaceModel& model, const std::vector<Eigen::Vector3f>& points) {
  EXPECT_TRUE(all_finite(model.to_json())) << model.to_json();
  for (const Eigen::Vector3f& p : points) {
    const float squared = model.squared_distance(p);
    EXPECT_TRUE(std::isfinite(squared) && squared >= 0) << squared;
    const SurfaceModel::Foot foot = model.foot(p);
    EXPECT_TRUE(foot.point.allFinite() && foot.normal.allFinite()) << foot.point << ' ' << foot.normal;
    EXPECT_NEAR(foot.normal.norm(), 1, 1e-3);
  }
}

TEST(Fitters, GiveFiniteSurfacesOrNone) {
  for_each_case([](Chance& chance) {
    const std::vector<Eigen::Vector3f> a = any_points(chance), b = any_points(chance);
    std::vector<Eigen::Vector3f> both = a;
    both.insert(both.end(), b.begin(), b.end());
    for (const std::string& name : registry().names("fitter")) {
      SCOPED_TRACE(name);
      const auto fitter = any_component<Fitter>(chance, name);
      EXPECT_TRUE(std::isfinite(fitter->parameter_count()) && fitter->parameter_count() >= 0);
      const auto model_a = fitter->fit(a), model_b = fitter->fit(b);
      if (model_a) expect_sound(*model_a, both);
      if (!model_a || !model_b) continue;
      if (const auto merged = fitter->fit_merged(*model_a, a, *model_b, b)) expect_sound(*merged, both);
    }
  });
}

/// Values of every pair of a few surfaces that lie apart or touch.
void expect_values_in_range(const Relation& relation, const Scene& scene, const std::vector<SurfacePair>& pairs) {
  const auto& declared = relation.values();
  const auto measure = relation.bind(scene);
  ASSERT_TRUE(measure);
  std::vector<double> values(declared.size() * pairs.size(), std::nan(""));
  measure->measure(pairs, values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const RelationValue& value = declared[i % declared.size()];
    EXPECT_TRUE(std::isfinite(values[i]) && values[i] >= value.low && values[i] <= value.high)
        << value.name << " = " << values[i] << " is not in [" << value.low << ", " << value.high << "]";
  }
}

/// At most 24: those that touch, and some that do not.
std::vector<SurfacePair> some_pairs(Chance& chance, const SurfaceSet& surfaces) {
  std::vector<SurfacePair> pairs;
  for (const Adjacency& border : surfaces.adjacencies)
    if (pairs.size() < 16) pairs.push_back({border.a, border.b, &border});
  const int count = int(surfaces.surfaces.size());
  for (int i = 0; i < 8 && count > 1; ++i) {
    const int a = chance.whole(0, count - 2), b = chance.whole(a + 1, count - 1);
    const auto touches = [&](const Adjacency& border) { return border.a == a && border.b == b; };
    const auto border = std::find_if(surfaces.adjacencies.begin(), surfaces.adjacencies.end(), touches);
    pairs.push_back({a, b, border == surfaces.adjacencies.end() ? nullptr : &*border});
  }
  return pairs;
}

TEST(Relations, GiveFiniteValuesInTheirRanges) {
  std::vector<std::shared_ptr<const Fitter>> fitters;
  for (const char* name : {"plane", "bspline"}) fitters.push_back(registry().create<Fitter>(name, {}));
  for_each_case([&](Chance& chance) {
    const Frame frame = hostile_frame(chance);
    const PatchMap patches = hostile_patches(chance, frame);
    const SurfaceSet surfaces = model_surfaces(frame, patches, fitters, {});
    std::map<std::string, std::shared_ptr<const Relation>> relations;  // they outlive the scene
    for (const std::string& name : registry().names("relation"))
      relations[name] = any_component<Relation>(chance, name);
    const Scene scene(frame, patches, surfaces);
    const std::vector<SurfacePair> pairs = some_pairs(chance, surfaces);
    for (const auto& [name, relation] : relations) {
      SCOPED_TRACE(name);
      expect_values_in_range(*relation, scene, pairs);
    }
  });
}

}  // namespace
}  // namespace gestalt::properties
