// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/outline.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "gestalt/core/scene/point_blocks.h"

namespace gestalt {

namespace {

std::vector<int> spread(const std::vector<Contour>& contours) {
  std::size_t count = 0;
  for (const Contour& contour : contours) count += contour.pixels.size();
  const std::size_t step = (count + Outline::largest - 1) / Outline::largest;
  std::vector<int> pixels;
  std::size_t next = 0;
  for (const Contour& contour : contours) {
    for (; next < contour.pixels.size(); next += step) pixels.push_back(contour.pixels[next]);
    next -= contour.pixels.size();
  }
  return pixels;
}

Outline outline_of(const Frame& frame, const SurfaceModel& model, std::vector<int> pixels) {
  const auto count = Eigen::Index(pixels.size());
  Outline outline{std::move(pixels), Eigen::Matrix3Xf(3, count), Eigen::Matrix3Xf(3, count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const SurfaceModel::Foot foot = model.foot(frame.point(outline.pixels[std::size_t(i)]));
    outline.points.col(i) = foot.point;
    outline.normals.col(i) = foot.normal;
  }
  return outline;
}

}  // namespace

std::vector<Outline> find_outlines(const Frame& frame, const SurfaceSet& surfaces,
                                   const std::vector<std::vector<Contour>>& contours) {
  std::vector<Outline> outlines(contours.size());
  tbb::parallel_for(std::size_t{0}, contours.size(), [&](std::size_t i) {
    outlines[i] = outline_of(frame, *surfaces.surfaces[i].model, spread(contours[i]));
  });
  return outlines;
}

std::vector<NearestPoint> nearest_points(const Eigen::Matrix3Xf& from, const Eigen::Matrix3Xf& to, double share) {
  return nearest_points(PointBlocks(from), PointBlocks(to), share);
}

std::vector<int> spread_columns(const Outline& outline, int count) {
  const auto columns = std::int64_t(outline.pixels.size()), taken = std::min<std::int64_t>(columns, count);
  std::vector<int> indices;
  for (std::int64_t i = 0; i < taken; ++i) indices.push_back(int(i * columns / taken));
  return indices;
}

}  // namespace gestalt
