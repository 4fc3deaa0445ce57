// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// The primitive level: fitting a patch of 5000 points, fitting two merged patches, and modelling a frame of 100
// patches. The counters tell the error against the closed form (root mean square over the patch, micrometres).

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <random>

#include "bspline.h"
#include "gestalt/core/pipeline/surface_modelling.h"
#include "plane.h"

namespace {

using namespace gestalt;
using Points = std::vector<Eigen::Vector3f>;

constexpr float noise = 0.0015f;  // m, of the depth: the Kinect's at 0.8 m

/// 100 x 50 points of the shape z(x, y) over 20 cm x 10 cm.
template <class Shape>
Points patch(const Shape& z, float sigma) {
  std::mt19937 generator(1);
  std::normal_distribution<float> normal(0, 1);
  Points points;
  for (int v = 0; v < 50; ++v)
    for (int u = 0; u < 100; ++u) {
      const float x = 0.002f * float(u - 50), y = 0.002f * float(v - 25);
      points.push_back({x, y, z(x, y) + sigma * normal(generator)});
    }
  return points;
}

float plane_shape(float x, float y) { return 0.8f + 0.3f * x - 0.2f * y; }
float cylinder_shape(float, float y) { return 0.88f - std::sqrt(0.08f * 0.08f - y * y); }
float sphere_shape(float x, float y) { return 1.0f - std::sqrt(0.2f * 0.2f - x * x - y * y); }
float saddle_shape(float x, float y) { return 0.8f + 2 * (x * x - y * y); }

Bspline bspline(int control_points) {
  Bspline::Params params;
  params.control_points_xi = params.control_points_eta = control_points;
  return Bspline(params);
}

template <float (*shape)(float, float)>
void fit(benchmark::State& state) {
  const Points exact = patch(shape, 0), points = patch(shape, noise);
  const Bspline fitter = bspline(int(state.range(0)));
  std::shared_ptr<const SurfaceModel> model;
  for (auto _ : state) benchmark::DoNotOptimize(model = fitter.fit(points));
  double sum = 0;
  for (const Eigen::Vector3f& p : exact) sum += double(model->squared_distance(p));
  state.counters["rms_um"] = 1e6 * std::sqrt(sum / double(exact.size()));
}

void fit_merged(benchmark::State& state) {
  const Points points = patch(saddle_shape, noise), exact = patch(saddle_shape, 0);
  const Points upper(points.begin(), points.begin() + 2500), lower(points.begin() + 2500, points.end());
  const Bspline fitter = bspline(int(state.range(0)));
  const auto a = fitter.fit(upper), b = fitter.fit(lower);
  std::shared_ptr<const SurfaceModel> model;
  for (auto _ : state) benchmark::DoNotOptimize(model = fitter.fit_merged(*a, upper, *b, lower));
  double sum = 0;
  for (const Eigen::Vector3f& p : exact) sum += double(model->squared_distance(p));
  state.counters["rms_um"] = 1e6 * std::sqrt(sum / double(exact.size()));
}

void closest_point(benchmark::State& state) {
  const auto model = bspline(int(state.range(0))).fit(patch(saddle_shape, 0));
  const Points points = patch(saddle_shape, noise);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(model->squared_distance(points[i++ % points.size()]));
}

/// Ten cylinders of 10 cm radius side by side, each in ten strips: 100 patches of 400 points or so.
void model_100_patches(benchmark::State& state) {
  constexpr int cylinders = 10, strips = 10, width = 640, height = 80;
  std::mt19937 generator(1);
  std::normal_distribution<float> normal(0, noise);
  cv::Mat_<float> depth(height, width);
  PatchMap patches{cv::Mat_<int>(height, width), cv::Mat_<cv::Vec3f>(height, width, cv::Vec3f(0, 0, -1)),
                   cylinders * strips};
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const float turn = float(u % 64) / 32 - 1;  // across one cylinder
      depth(v, u) = 0.9f - 0.06f * std::sqrt(1 - 0.8f * turn * turn) + normal(generator);
      patches.labels(v, u) = 1 + u / 64 * strips + (u % 64) * strips / 64;
    }
  const Frame frame = make_frame("cylinders", {}, depth, {width, height, 525, 525, 319.5, 39.5});
  std::vector<std::shared_ptr<const Fitter>> fitters{std::make_shared<Plane>(Plane::Params{})};
  if (state.range(0)) fitters.push_back(std::make_shared<Bspline>(Bspline::Params{}));
  SurfaceSet surfaces;
  for (auto _ : state) surfaces = model_surfaces(frame, patches, fitters, {});
  state.counters["surfaces"] = double(surfaces.surfaces.size());
}

BENCHMARK(fit<plane_shape>)->ArgName("control_points")->Arg(3)->Arg(6)->Unit(benchmark::kMillisecond);
BENCHMARK(fit<cylinder_shape>)->ArgName("control_points")->Arg(3)->Arg(6)->Unit(benchmark::kMillisecond);
BENCHMARK(fit<sphere_shape>)->ArgName("control_points")->Arg(3)->Arg(6)->Unit(benchmark::kMillisecond);
BENCHMARK(fit<saddle_shape>)->ArgName("control_points")->Arg(3)->Arg(6)->Unit(benchmark::kMillisecond);
BENCHMARK(fit_merged)->ArgName("control_points")->Arg(3)->Arg(6)->Unit(benchmark::kMillisecond);
BENCHMARK(closest_point)->ArgName("control_points")->Arg(3)->Arg(6);
BENCHMARK(model_100_patches)->ArgName("bspline")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
