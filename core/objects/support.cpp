// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "support.h"

#include <algorithm>
#include <cmath>

#include "gestalt/core/base/quantile.h"
#include "gestalt/core/scene/moments.h"

namespace gestalt {

namespace {

constexpr double behind = 0.015;    // m, that an object's points may be behind its support: depth is curved and noisy
constexpr double low_share = 0.02;  // of the points, which are not looked at: pixels at edges lie between things
constexpr std::size_t samples = 2000;  // points of a plane

Eigen::Vector3d point_of(const Frame& frame, int pixel) { return frame.point(pixel).cast<double>(); }

}  // namespace

std::vector<BackgroundPlane> background_planes(const Percept& percept) {
  constexpr double least_share = 0.001, flatness = 0.01;
  const Frame& frame = percept.frame();
  const double frame_pixels = double(frame.depth.total());
  std::vector<BackgroundPlane> planes;
  for (std::size_t i = 0; i < percept.surfaces().surfaces.size(); ++i) {
    const std::vector<int>& pixels = percept.surfaces().surfaces[i].pixels;
    const double share = double(pixels.size()) / frame_pixels;
    if (percept.roles[i] != Role::background || share < least_share) continue;
    const Eigen::Vector3d origin = point_of(frame, pixels.front());
    Moments moments;
    const std::size_t step = std::max<std::size_t>(1, pixels.size() / samples);
    for (std::size_t k = 0; k < pixels.size(); k += step) moments.add(point_of(frame, pixels[k]) - origin);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments.covariance());
    if (!(axes.eigenvalues()[0] <= flatness * flatness * axes.eigenvalues()[2])) continue;
    const Eigen::Vector3d mean = origin + moments.mean();
    Eigen::Vector3d normal = axes.eigenvectors().col(0);
    if (normal.dot(mean) > 0) normal = -normal;
    planes.push_back({int(i), normal, normal.dot(mean), share});
  }
  return planes;
}

std::optional<Support> find_support(const std::vector<BackgroundPlane>& planes, const Percept& percept,
                                    const std::vector<int>& surfaces, const Points& points) {
  if (points.empty()) return std::nullopt;
  const auto is_own = [&](int patch) { return std::binary_search(surfaces.begin(), surfaces.end(), patch); };
  std::vector<bool> touched(percept.surfaces().surfaces.size(), false);
  for (const Adjacency& pair : percept.surfaces().adjacencies)
    if (is_own(pair.a) != is_own(pair.b)) touched[std::size_t(is_own(pair.a) ? pair.b : pair.a)] = true;

  std::optional<Support> nearest, largest;
  double largest_share = 0;
  for (const BackgroundPlane& plane : planes) {
    std::vector<double> heights(points.size());
    std::transform(points.begin(), points.end(), heights.begin(),
                   [&](const Eigen::Vector3d& p) { return plane.normal.dot(p) - plane.offset; });
    Support support{plane.patch, plane.normal, plane.offset, quantile(heights, low_share),
                    quantile(heights, 1 - low_share)};
    if (support.bottom < -behind) continue;
    if (touched[std::size_t(plane.patch)] && (!nearest || support.bottom < nearest->bottom)) nearest = support;
    if (plane.share > largest_share) largest = support, largest_share = plane.share;
  }
  return nearest ? nearest : largest;
}

}  // namespace gestalt
