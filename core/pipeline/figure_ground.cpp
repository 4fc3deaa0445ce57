// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/pipeline/figure_ground.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "gestalt/core/scene/moments.h"

namespace gestalt {

namespace {

constexpr std::size_t samples_of_a_frame = 20000;
constexpr std::size_t fewest_samples = 20, most_samples = 300;  // of a surface
constexpr std::size_t largest_number_of_sheets = 64;
constexpr double most = 0.8;  // of a surface's points: decides where it lies

/// An even sample of a surface's points. Every point stands for `pixels / points.size()` pixels.
struct Cloud {
  std::vector<Eigen::Vector3f> points;
  double pixels = 0;
};

struct Plane {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = -Eigen::Vector3d::UnitZ();  // towards the camera

  /// Positive on the camera's side.
  double distance(const Eigen::Vector3f& p) const { return normal.dot(p.cast<double>() - point); }
};

void add(Moments& moments, const Cloud& cloud) {
  const double each = cloud.pixels / double(cloud.points.size());
  for (const Eigen::Vector3f& p : cloud.points) moments.add(p.cast<double>(), each);
}

Plane plane_of(const Moments& moments) { return {moments.mean(), moments.normal()}; }

/// Shares of a surface's points relative to a sheet.
struct Position {
  double within = 0;
  double before = 0;       ///< on the camera's side
  double before_hull = 0;  ///< those over the sheet's hull
  double behind = 0;
};

/// Coplanar surfaces, and the hull around them.
class Sheet {
 public:
  Plane plane;
  std::vector<int> surfaces;
  double area = 0;      // m^2
  double diameter = 0;  // m, of the hull

  void enclose(const std::vector<Cloud>& clouds) {
    first_axis_ = plane.normal.unitOrthogonal();
    second_axis_ = plane.normal.cross(first_axis_);
    std::vector<cv::Point2f> points, hull;
    for (const int s : surfaces)
      for (const Eigen::Vector3f& p : clouds[std::size_t(s)].points) points.push_back(in_plane(p));
    cv::convexHull(points, hull);
    for (const cv::Point2f& a : hull)
      for (const cv::Point2f& b : hull) diameter = std::max(diameter, double(cv::norm(a - b)));
    cv::Point2f middle(0, 0);
    for (const cv::Point2f& corner : hull) middle += corner / float(hull.size());
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const cv::Point2f corner = hull[i], along = hull[(i + 1) % hull.size()] - corner;
      const double length = cv::norm(along);
      if (!(length > 0)) continue;
      cv::Point2f outward = cv::Point2f(along.y, -along.x) / float(length);
      if (outward.dot(middle - corner) > 0) outward = -outward;
      edges_.push_back({outward, outward.dot(corner)});
    }
  }

  /// Whether a point lies over the hull, or outside none of its edges by more than margin metres.
  bool holds(const Eigen::Vector3f& p, double margin) const {
    const cv::Point2f q = in_plane(p);
    return std::all_of(edges_.begin(), edges_.end(),
                       [&](const Edge& edge) { return double(edge.outward.dot(q) - edge.offset) <= margin; });
  }

 private:
  cv::Point2f in_plane(const Eigen::Vector3f& p) const {
    const Eigen::Vector3d q = p.cast<double>() - plane.point;
    return {float(first_axis_.dot(q)), float(second_axis_.dot(q))};
  }

  Eigen::Vector3d first_axis_, second_axis_;
  struct Edge {
    cv::Point2f outward;  // unit normal
    float offset;
  };
  std::vector<Edge> edges_;
};

class FigureGround {
 public:
  FigureGround(const Frame& frame, const SurfaceSet& surfaces, const FigureGroundParams& params)
      : frame_(frame), surfaces_(surfaces), params_(params), roles_(surfaces.surfaces.size(), Role::object) {
    for (const Surface& surface : surfaces.surfaces) {
      clouds_.push_back(sample(surface));
      all_pixels_ += clouds_.back().pixels;
    }
    touching_.resize(clouds_.size());
    for (const Adjacency& adjacency : surfaces.adjacencies)
      if (!adjacency.border_3d.empty()) {
        touching_[std::size_t(adjacency.a)].push_back(adjacency.b);
        touching_[std::size_t(adjacency.b)].push_back(adjacency.a);
      }
  }

  std::vector<Role> roles() {
    const std::vector<Sheet> sheets = find_sheets();
    const Sheet* ground = find_ground(sheets);
    if (!ground) return roles_;
    accept(*ground);
    for (const Sheet& sheet : sheets)
      if (&sheet != ground && is_wall(sheet, *ground)) accept(sheet);
    for (const Sheet& sheet : sheets)
      if (!is_background(sheet) && is_table(sheet, *ground)) accept(sheet);
    for (std::size_t s = 0; s < clouds_.size(); ++s)
      if (!is_on_a_support(clouds_[s])) roles_[s] = Role::background;
    return roles_;
  }

 private:
  Cloud sample(const Surface& surface) const {
    Cloud cloud;
    cloud.pixels = double(surface.pixels.size());
    const std::size_t samples =
        std::clamp(samples_of_a_frame / surfaces_.surfaces.size(), fewest_samples, most_samples);
    const std::size_t step = (surface.pixels.size() + samples - 1) / samples;
    for (std::size_t i = 0; i < surface.pixels.size(); i += step)
      cloud.points.push_back(frame_.point(surface.pixels[i]));
    return cloud;
  }

  double tolerance(const Eigen::Vector3f& p) const { return params_.tolerance * frame_.noise.at(double(p.z())); }

  /// Whether most points of a surface lie in a plane, and its mean half as near: noise averages out, the bottom of a
  /// bowl stays above the table.
  bool lies_in(const Cloud& cloud, const Plane& plane) const {
    std::size_t near = 0;
    double sum = 0;
    for (const Eigen::Vector3f& p : cloud.points) {
      const double deviation = plane.distance(p) / tolerance(p);
      near += std::abs(deviation) < 1;
      sum += deviation;
    }
    const auto count = double(cloud.points.size());
    return double(near) >= most * count && std::abs(sum) < 0.5 * count;
  }

  Position position(const Cloud& cloud, const Sheet& sheet, double margin) const {
    Position position;
    const double each = 1 / double(cloud.points.size());
    for (const Eigen::Vector3f& p : cloud.points) {
      const double distance = sheet.plane.distance(p);
      if (std::abs(distance) < tolerance(p)) {
        position.within += each;
      } else if (distance < 0) {
        position.behind += each;
      } else {
        position.before += each;
        if (sheet.holds(p, margin)) position.before_hull += each;
      }
    }
    return position;
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

  /// The surfaces in the plane of a seed. The plane is fitted anew once to all that are found.
  Sheet grow(int seed) const {
    Moments moments;
    add(moments, clouds_[std::size_t(seed)]);
    Sheet sheet;
    for (int round = 0; round < 2; ++round) {
      sheet.plane = plane_of(moments);
      sheet.surfaces.clear();
      moments = {};
      for (std::size_t s = 0; s < clouds_.size(); ++s)
        if (lies_in(clouds_[s], sheet.plane)) {
          sheet.surfaces.push_back(int(s));
          add(moments, clouds_[s]);
        }
      if (sheet.surfaces.empty()) return sheet;
    }
    for (const int s : sheet.surfaces) sheet.area += area_on(sheet.plane, clouds_[std::size_t(s)]);
    sheet.enclose(clouds_);
    return sheet;
  }

  /// Largest first.
  std::vector<Sheet> find_sheets() const {
    std::vector<std::pair<double, int>> seeds;
    for (std::size_t s = 0; s < clouds_.size(); ++s) {
      Moments moments;
      add(moments, clouds_[s]);
      const Plane plane = plane_of(moments);
      if (lies_in(clouds_[s], plane)) seeds.emplace_back(-area_on(plane, clouds_[s]), int(s));
    }
    std::sort(seeds.begin(), seeds.end());
    std::vector<bool> used(clouds_.size(), false);
    std::vector<Sheet> sheets;
    for (const auto& [area, seed] : seeds) {
      if (used[std::size_t(seed)]) continue;
      if (sheets.size() == largest_number_of_sheets) break;
      Sheet sheet = grow(seed);
      if (sheet.surfaces.empty()) continue;
      for (const int s : sheet.surfaces) used[std::size_t(s)] = true;
      sheets.push_back(std::move(sheet));
    }
    std::stable_sort(sheets.begin(), sheets.end(), [](const Sheet& x, const Sheet& y) { return x.area > y.area; });
    return sheets;
  }

  /// Where the frame's points lie, as shares of all.
  Position position_of_all(const Sheet& sheet) const {
    Position all;
    for (const Cloud& cloud : clouds_) {
      const Position own = position(cloud, sheet, 0);
      const double weight = cloud.pixels / all_pixels_;
      all.within += weight * own.within;
      all.before += weight * own.before;
      all.before_hull += weight * own.before_hull;
      all.behind += weight * own.behind;
    }
    return all;
  }

  const Sheet* find_ground(const std::vector<Sheet>& sheets) const {
    const Sheet* ground = nullptr;
    double best = 0;
    for (const Sheet& sheet : sheets) {
      const Position all = position_of_all(sheet);
      if (all.behind > params_.largest_remainder && all.before_hull < params_.largest_remainder) continue;
      const double explained = all.within + all.before_hull - all.behind;
      if (ground && explained <= best) continue;
      ground = &sheet;
      best = explained;
    }
    return ground;
  }

  bool is_wall(const Sheet& sheet, const Sheet& ground) const {
    return sheet.area >= params_.relative_area * ground.area &&
           position_of_all(sheet).behind <= params_.largest_remainder;
  }

  bool is_table(const Sheet& sheet, const Sheet& ground) const {
    double standing = 0, own = 0, over_ground = 0;
    std::vector<bool> counted(clouds_.size(), false);
    for (const int s : sheet.surfaces) {
      const Cloud& cloud = clouds_[std::size_t(s)];
      own += cloud.pixels;
      over_ground += cloud.pixels * position(cloud, ground, params_.margin * ground.diameter).before_hull;
      counted[std::size_t(s)] = true;
    }
    const bool large_enough =
        2 * over_ground > own ? sheet.area >= params_.smallest_support : own >= params_.largest_remainder * all_pixels_;
    if (sheet.area < params_.relative_area * ground.area && (!large_enough || leads_to_a_support(sheet))) return false;
    for (const int s : sheet.surfaces)
      for (const int other : touching_[std::size_t(s)]) {
        if (counted[std::size_t(other)] || roles_[std::size_t(other)] == Role::background) continue;
        counted[std::size_t(other)] = true;
        const Cloud& cloud = clouds_[std::size_t(other)];
        const Position where = position(cloud, sheet, 0);
        if (where.before_hull > where.behind) standing += where.before_hull * cloud.pixels;
      }
    return standing >= params_.largest_remainder * own;
  }

  /// Whether touching surfaces lead from a sheet to a support.
  bool leads_to_a_support(const Sheet& sheet) const {
    std::vector<bool> reached(clouds_.size(), false);
    std::vector<int> open = sheet.surfaces;
    for (const int s : open) reached[std::size_t(s)] = true;
    while (!open.empty()) {
      const int s = open.back();
      open.pop_back();
      if (roles_[std::size_t(s)] == Role::background) return true;
      for (const int other : touching_[std::size_t(s)])
        if (!reached[std::size_t(other)]) {
          reached[std::size_t(other)] = true;
          open.push_back(other);
        }
    }
    return false;
  }

  bool is_background(const Sheet& sheet) const {
    return std::all_of(sheet.surfaces.begin(), sheet.surfaces.end(),
                       [&](int s) { return roles_[std::size_t(s)] == Role::background; });
  }

  void accept(const Sheet& sheet) {
    supports_.push_back(&sheet);
    for (const int s : sheet.surfaces) roles_[std::size_t(s)] = Role::background;
  }

  /// Whether a surface is before some support and over it, and not in the plane of any.
  bool is_on_a_support(const Cloud& cloud) const {
    bool on = false;
    for (const Sheet* support : supports_) {
      const Position where = position(cloud, *support, params_.margin * support->diameter);
      if (lies_in(cloud, support->plane)) return false;
      on = on || where.before_hull >= where.behind + (where.before - where.before_hull);
    }
    return on;
  }

  const Frame& frame_;
  const SurfaceSet& surfaces_;
  const FigureGroundParams& params_;
  std::vector<Cloud> clouds_;
  std::vector<std::vector<int>> touching_;
  std::vector<Role> roles_;
  std::vector<const Sheet*> supports_;
  double all_pixels_ = 0;
};

}  // namespace

std::vector<Role> find_roles(const Frame& frame, const SurfaceSet& surfaces, const FigureGroundParams& params) {
  return FigureGround(frame, surfaces, params).roles();
}

}  // namespace gestalt
