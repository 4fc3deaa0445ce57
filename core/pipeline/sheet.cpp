// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "sheet.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace gestalt {

namespace {

constexpr std::size_t samples_of_a_frame = 20000;
constexpr std::size_t fewest_samples = 20, most_samples = 300;  // of a surface
constexpr std::size_t most_seeds = 64;  // of the largest area; bounds the work in a frame of many surfaces
constexpr double most = 0.8;            // of a surface's points: decides where it lies
constexpr double main_parts = 0.9;      // of a sheet's pixels: the specks beside them that happen to lie in its plane
                                        // are not to widen its hull
constexpr double flatness = 0.01;       // of a plane's extent; errors of depth other than noise bend planes by less

void add(Moments& moments, const Cloud& cloud) {
  const double each = cloud.pixels / double(cloud.points.size());
  for (const Eigen::Vector3f& p : cloud.points) moments.add(p.cast<double>(), each);
}

double quantile_of(std::vector<double>& values, double share) {
  const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// 4 standard deviations of the points in their direction of largest spread: about the diameter of a plane.
double extent_of(const Moments& moments) {
  return 4 * std::sqrt(
                 std::max(0.0, Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments.covariance()).eigenvalues()(2)));
}

}  // namespace

std::vector<Cloud> sample_surfaces(const Frame& frame, const SurfaceSet& surfaces, double max_depth) {
  std::vector<Cloud> clouds;
  const std::size_t samples =
      std::clamp(samples_of_a_frame / std::max<std::size_t>(surfaces.surfaces.size(), 1), fewest_samples, most_samples);
  for (const Surface& surface : surfaces.surfaces) {
    Cloud cloud;
    const std::size_t step = (surface.pixels.size() + samples - 1) / samples;
    std::size_t away = 0;
    for (std::size_t i = 0; i < surface.pixels.size(); i += step) {
      const Eigen::Vector3f p = frame.point(surface.pixels[i]);
      away += max_depth > 0 && double(p.z()) > max_depth;
      cloud.weight += 1 / (double(p.z()) * double(p.z()));
      cloud.points.push_back(p);
    }
    if (2 * away > cloud.points.size()) {
      clouds.emplace_back();
      continue;
    }
    cloud.pixels = double(surface.pixels.size());
    cloud.weight *= cloud.pixels / double(cloud.points.size());
    clouds.push_back(std::move(cloud));
  }
  return clouds;
}

// ------------------------------------------------------------------------------------------------------------ a sheet

bool Sheet::has(const Cloud& cloud, const DepthNoise& noise) const {
  const auto count = double(cloud.points.size());
  double away = 0, sum = 0;
  for (const Eigen::Vector3f& p : cloud.points) {
    const double deviation = plane.distance(p) / (tolerance * noise.at(double(p.z())));
    if (!(std::abs(deviation) < 1) && ++away > (1 - most) * count) return false;
    sum += deviation;
  }
  return std::abs(sum) < 0.5 * count;
}

Position Sheet::position(const Cloud& cloud, const DepthNoise& noise, double margin) const {
  Position position;
  const double each = 1 / double(cloud.points.size());
  for (const Eigen::Vector3f& p : cloud.points) {
    const double distance = plane.distance(p);
    if (std::abs(distance) < tolerance * noise.at(double(p.z()))) {
      position.within += each;
    } else if (distance < 0) {
      position.behind += each;
    } else {
      position.before += each;
      if (holds(p, margin)) position.before_hull += each;
    }
  }
  return position;
}

cv::Point2f Sheet::in_plane(const Eigen::Vector3f& p) const {
  const Eigen::Vector3d q = p.cast<double>() - plane.point;
  return {float(first_axis_.dot(q)), float(second_axis_.dot(q))};
}

bool Sheet::holds(const Eigen::Vector3f& p, double margin) const {
  const cv::Point2f q = in_plane(p);
  return std::all_of(edges_.begin(), edges_.end(),
                     [&](const Edge& edge) { return double(edge.outward.dot(q) - edge.offset) <= margin; });
}

double Sheet::extent(const Eigen::Vector3d& direction) const {
  const cv::Point2f along(float(first_axis_.dot(direction)), float(second_axis_.dot(direction)));
  float low = 0, high = 0;
  for (const cv::Point2f& corner : corners_) {
    low = std::min(low, along.dot(corner));
    high = std::max(high, along.dot(corner));
  }
  return double(high - low);
}

void Sheet::enclose(const std::vector<Cloud>& clouds) {
  first_axis_ = plane.normal.unitOrthogonal();
  second_axis_ = plane.normal.cross(first_axis_);
  std::vector<int> by_size = surfaces;
  std::stable_sort(by_size.begin(), by_size.end(),
                   [&](int a, int b) { return clouds[std::size_t(a)].pixels > clouds[std::size_t(b)].pixels; });
  std::vector<cv::Point2f> points;
  double enclosed = 0;
  for (const int s : by_size) {
    if (enclosed >= main_parts * pixels) break;
    enclosed += clouds[std::size_t(s)].pixels;
    for (const Eigen::Vector3f& p : clouds[std::size_t(s)].points) points.push_back(in_plane(p));
  }
  cv::convexHull(points, corners_);
  diameter = 0;
  for (const cv::Point2f& a : corners_)
    for (const cv::Point2f& b : corners_) diameter = std::max(diameter, double(cv::norm(a - b)));
  cv::Point2f middle(0, 0);
  for (const cv::Point2f& corner : corners_) middle += corner / float(corners_.size());
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const cv::Point2f corner = corners_[i], along = corners_[(i + 1) % corners_.size()] - corner;
    const double length = cv::norm(along);
    if (!(length > 0)) continue;
    cv::Point2f outward = cv::Point2f(along.y, -along.x) / float(length);
    if (outward.dot(middle - corner) > 0) outward = -outward;
    edges_.push_back({outward, outward.dot(corner)});
  }
}

// ------------------------------------------------------------------------------------------------------------ finding

class SheetSearch {
 public:
  SheetSearch(const Frame& frame, const std::vector<Cloud>& clouds, double tolerance)
      : frame_(frame), clouds_(clouds), tolerance_(tolerance) {}

  /// A surface is a seed when it is flat: by the noise, or by its extent, so that a large one may be bent as the
  /// sensor's errors bend it. Seeds in order of area.
  std::vector<Sheet> find() const {
    std::vector<std::pair<double, int>> seeds;
    for (std::size_t s = 0; s < clouds_.size(); ++s) {
      const Sheet sheet = plane_of({int(s)});
      if (sheet.diameter > 0 && sheet.has(clouds_[s], frame_.noise))
        seeds.emplace_back(-area_on(sheet.plane, clouds_[s]), int(s));
    }
    std::sort(seeds.begin(), seeds.end());
    std::vector<bool> used(clouds_.size(), false);
    std::vector<Sheet> sheets;
    std::size_t tried = 0;
    for (const auto& [area, seed] : seeds) {
      if (used[std::size_t(seed)]) continue;
      if (++tried > most_seeds) break;
      Sheet sheet = grow(seed);
      if (sheet.surfaces.empty()) continue;
      for (const int s : sheet.surfaces) used[std::size_t(s)] = true;
      sheets.push_back(std::move(sheet));
    }
    std::stable_sort(sheets.begin(), sheets.end(), [](const Sheet& x, const Sheet& y) { return x.area > y.area; });
    return sheets;
  }

 private:
  static bool reaches(const Cloud& cloud, const Sheet& sheet) {
    return std::any_of(cloud.points.begin(), cloud.points.end(), [&](const Eigen::Vector3f& p) {
      return (p.cast<double>() - sheet.plane.point).norm() < sheet.diameter;
    });
  }

  /// Plane, tolerance and about the diameter.
  Sheet plane_of(const std::vector<int>& surfaces) const {
    Sheet sheet;
    Moments moments;
    for (const int s : surfaces) add(moments, clouds_[std::size_t(s)]);
    if (!(moments.weight > 0)) return sheet;
    sheet.plane = {moments.mean(), moments.normal()};
    std::vector<double> deviations;
    double sigma = 0;
    for (const int s : surfaces)
      for (const Eigen::Vector3f& p : clouds_[std::size_t(s)].points) {
        const double noise = frame_.noise.at(double(p.z()));
        deviations.push_back(std::abs(sheet.plane.distance(p)) / noise);
        sigma += noise;
      }
    sigma /= double(deviations.size());
    const double roughness = quantile_of(deviations, 0.68);
    const double bent = flatness * extent_of(moments) / sigma;
    sheet.tolerance = std::max(tolerance_, std::min(tolerance_ * roughness, bent));
    sheet.diameter = extent_of(moments);
    return sheet;
  }

  /// The surfaces in the plane of a seed, no farther from it than its size: what lies in a plane by chance, elsewhere
  /// in the room, is not part of a table. The plane is fitted once more to all that are found.
  Sheet grow(int seed) const {
    std::vector<int> members{seed};
    Sheet sheet;
    for (int round = 0; round < 2; ++round) {
      sheet = plane_of(members);
      members.clear();
      for (std::size_t s = 0; s < clouds_.size(); ++s)
        if (sheet.has(clouds_[s], frame_.noise) && reaches(clouds_[s], sheet)) members.push_back(int(s));
      if (members.empty()) return {};
    }
    sheet.surfaces = members;
    for (const int s : members) {
      const Cloud& cloud = clouds_[std::size_t(s)];
      sheet.area += area_on(sheet.plane, cloud);
      sheet.pixels += cloud.pixels;
      sheet.weight += cloud.weight;
    }
    sheet.enclose(clouds_);
    return sheet;
  }

  /// Area that a surface covers on a plane, in square metres.
  double area_on(const Plane& plane, const Cloud& cloud) const {
    double sum = 0;
    for (const Eigen::Vector3f& p : cloud.points) {
      const Eigen::Vector3d ray = p.cast<double>() / double(p.z());
      // At less than 3 degrees to the plane a pixel's area is anybody's guess.
      const double slant = std::max(std::abs(plane.normal.dot(ray)), 0.05 * ray.norm());
      sum += double(p.z()) * double(p.z()) / (frame_.camera.fx * frame_.camera.fy * slant);
    }
    return sum * cloud.pixels / double(cloud.points.size());
  }

  const Frame& frame_;
  const std::vector<Cloud>& clouds_;
  double tolerance_;
};

std::vector<Sheet> find_sheets(const Frame& frame, const std::vector<Cloud>& clouds, double tolerance) {
  return SheetSearch(frame, clouds, tolerance).find();
}

}  // namespace gestalt
