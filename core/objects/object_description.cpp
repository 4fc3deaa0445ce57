// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/objects/object_description.h"

#include <algorithm>
#include <cmath>

#include "confidence.h"
#include "gestalt/core/base/for_all.h"
#include "gestalt/core/base/isolated.h"
#include "gestalt/core/scene/moments.h"
#include "oriented_box.h"
#include "shape_kind.h"
#include "support.h"

namespace gestalt {

namespace {

constexpr std::size_t most_points = 4000;  // of a surface that shapes are fitted to

/// What the pixels of an object's surfaces tell by themselves.
struct Pixels {
  cv::Rect box;
  Moments points;  ///< relative to the first point
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  std::optional<Colour> colour;
};

Pixels look_at(const Frame& frame, const SurfaceSet& surfaces, const Segment& segment) {
  Pixels seen;
  int left = frame.width(), right = -1, top = frame.height(), bottom = -1;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), squares = Eigen::Vector3d::Zero();
  double count = 0;
  for (const int surface : segment.surfaces)
    for (const int pixel : surfaces.surfaces[std::size_t(surface)].pixels) {
      const int u = pixel % frame.width(), v = pixel / frame.width();
      left = std::min(left, u), right = std::max(right, u);
      top = std::min(top, v), bottom = std::max(bottom, v);
      if (frame.valid(pixel)) {
        const Eigen::Vector3d p = frame.point(pixel).cast<double>();
        if (seen.points.weight == 0) seen.origin = p;
        seen.points.add(p - seen.origin);
      }
      if (!frame.has_colour()) continue;
      const cv::Vec3b& bgr = frame.colour.ptr<cv::Vec3b>()[pixel];
      const Eigen::Vector3d rgb(bgr[2], bgr[1], bgr[0]);
      sum += rgb;
      squares += rgb.cwiseProduct(rgb);
      ++count;
    }
  seen.box = right < left ? cv::Rect() : cv::Rect(left, top, right - left + 1, bottom - top + 1);
  if (count > 0) {
    const Eigen::Vector3d mean = sum / count;
    seen.colour = Colour{mean, (squares / count - mean.cwiseProduct(mean)).cwiseMax(0).cwiseSqrt()};
  }
  return seen;
}

/// The object's surfaces, the largest first.
std::vector<Facet> facets_of(const Frame& frame, const SurfaceSet& surfaces, const Segment& segment) {
  std::vector<Facet> facets;
  std::vector<int> order = segment.surfaces;
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return surfaces.surfaces[std::size_t(a)].pixels.size() > surfaces.surfaces[std::size_t(b)].pixels.size();
  });
  for (const int patch : order) {
    const std::vector<int>& pixels = surfaces.surfaces[std::size_t(patch)].pixels;
    Facet facet;
    facet.patch = patch;
    const std::size_t step = std::max<std::size_t>(1, pixels.size() / most_points);
    Moments moments;
    for (std::size_t i = 0; i < pixels.size(); i += step) {
      if (!frame.valid(pixels[i])) continue;
      facet.points.push_back(frame.point(pixels[i]).cast<double>());
      moments.add(facet.points.back() - facet.points.front());
    }
    if (facet.points.size() < 3) continue;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments.covariance());
    facet.rms = std::sqrt(std::max(0.0, axes.eigenvalues()[0]));
    facet.normal = axes.eigenvectors().col(0);
    if (facet.normal.dot(facet.points.front()) > 0) facet.normal = -facet.normal;
    facets.push_back(std::move(facet));
  }
  return facets;
}

/// The surface with the largest area of those that are flat to the tolerance. A pixel covers z^2 / (fx fy |n . d|),
/// where d is its ray with z = 1.
std::optional<Face> largest_face(const Frame& frame, const SurfaceSet& surfaces, const std::vector<Facet>& facets,
                                 double tolerance) {
  const double per_pixel = 1 / (frame.camera.fx * frame.camera.fy);
  std::optional<Face> largest;
  for (const Facet& facet : facets) {
    if (facet.rms > tolerance) continue;
    double area = 0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : facet.points) {
      constexpr double grazing = 0.05;  // beyond, an error of the normal counts more than the area
      area += p.z() * p.z() * per_pixel / std::max(grazing, std::abs(facet.normal.dot(p)) / p.z());
      centre += p;
    }
    area *= double(surfaces.surfaces[std::size_t(facet.patch)].pixels.size()) / double(facet.points.size());
    if (!largest || area > largest->area)
      largest = Face{facet.patch, centre / double(facet.points.size()), facet.normal, area};
  }
  return largest;
}

}  // namespace

std::vector<ObjectDescription> describe_objects(const SegmentedFrame& found) {
  const Frame& frame = found.percept.frame();
  const SurfaceSet& surfaces = found.percept.surfaces();
  const std::vector<Segment>& segments = found.segmentation.segments;
  const std::vector<Certainty> certainties = find_certainties(found.segmentation, pixel_density(frame.camera));
  const std::vector<BackgroundPlane> planes = background_planes(found.percept);

  std::vector<std::size_t> objects;
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (segments[i].role == Role::object) objects.push_back(i);
  std::vector<ObjectDescription> all(objects.size());
  const auto describe = [&](std::size_t k) {
    const Segment& segment = segments[objects[k]];
    const Pixels seen = look_at(frame, surfaces, segment);
    const std::vector<Facet> facets = facets_of(frame, surfaces, segment);
    ObjectDescription& object = all[k];
    object.label = int(objects[k]) + 1;
    object.pixels = segment.pixel_count;
    object.box = seen.box;
    object.colour = seen.colour;
    object.confidence = certainties[objects[k]].confidence;
    object.joins = certainties[objects[k]].joins;
    object.cuts = certainties[objects[k]].cuts;
    if (facets.empty()) return;
    object.centroid = seen.origin + seen.points.mean();

    Points points, normals;
    for (const Facet& facet : facets) {
      points.insert(points.end(), facet.points.begin(), facet.points.end());
      normals.push_back(facet.normal);
    }
    constexpr double sigmas = 2, least_tolerance = 0.003;  // m
    const double tolerance = std::max(least_tolerance, sigmas * frame.noise.at(std::max(1e-3, object.centroid.z())));
    object.support = find_support(planes, found.percept, segment.surfaces, points);
    object.oriented_box = box_around(points, object.support ? object.support->normal : normals.front(), normals);
    object.kind = find_kind(facets, object.oriented_box, object.support, tolerance);
    object.largest_face = largest_face(frame, surfaces, facets, tolerance);
  };
  isolated([&] { for_all(objects.size(), describe); });
  return all;
}

}  // namespace gestalt
