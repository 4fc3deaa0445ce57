// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/pipeline/figure_ground.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "sheet.h"

namespace gestalt {

namespace {

class FigureGround {
 public:
  FigureGround(const Frame& frame, const SurfaceSet& surfaces, const FigureGroundParams& params)
      : frame_(frame),
        surfaces_(surfaces),
        params_(params),
        clouds_(sample_surfaces(frame, surfaces, params.max_depth)),
        roles_(clouds_.size(), Role::object) {
    for (std::size_t s = 0; s < clouds_.size(); ++s) {
      if (clouds_[s].points.empty()) roles_[s] = Role::background;
      weight_ += clouds_[s].weight;
      pixels_ += clouds_[s].pixels;
    }
    touching_.resize(clouds_.size());
    for (const Adjacency& adjacency : surfaces.adjacencies)
      if (!adjacency.border_3d.empty()) {
        touching_[std::size_t(adjacency.a)].push_back(adjacency.b);
        touching_[std::size_t(adjacency.b)].push_back(adjacency.a);
      }
  }

  std::vector<Role> roles() {
    const std::vector<Sheet> sheets = find_sheets(frame_, clouds_, params_.tolerance);
    const Sheet* ground = find_ground(sheets);
    if (std::getenv("FG_DEBUG") && !std::getenv("FG_QUIET"))
      for (const Sheet& sheet : sheets)
        if (sheet.weight > 0.01 * weight_) {
          const Position all = position_of_all(sheet);
          fprintf(stderr, "SHEET %s area %.3f diam %.2f surfaces %zu share %.3f weight %.3f z %.2f tol %.1f at (%.0f,%.0f) n (%.2f %.2f %.2f) within %.3f hull %.3f before %.3f behind %.3f %s\n", frame_.name.c_str(), sheet.area, sheet.diameter, sheet.surfaces.size(), sheet.pixels/pixels_, sheet.weight/weight_, sheet.plane.point.z(), sheet.tolerance, sheet.plane.point.x()/sheet.plane.point.z()*frame_.camera.fx+frame_.camera.cx, sheet.plane.point.y()/sheet.plane.point.z()*frame_.camera.fy+frame_.camera.cy, sheet.plane.normal.x(), sheet.plane.normal.y(), sheet.plane.normal.z(), all.within, all.before_hull, all.before, all.behind, &sheet == ground ? "GROUND" : "");
        }
    if (!ground) return roles_;
    accept(*ground);
    for (const Sheet& sheet : sheets)
      if (&sheet != ground && is_wall(sheet, *ground)) accept(sheet);
    for (const Sheet& sheet : sheets)
      if (!is_background(sheet) && is_table(sheet, *ground)) accept(sheet);
    const std::vector<const Sheet*> stages = find_stages();
    for (std::size_t s = 0; s < clouds_.size(); ++s)
      if (!is_on_one_of(stages, clouds_[s])) roles_[s] = Role::background;
    return roles_;
  }

 private:
  /// Where the frame's points lie, as shares of the weight of all.
  Position position_of_all(const Sheet& sheet) const {
    Position all;
    for (const Cloud& cloud : clouds_) {
      const Position own = sheet.position(cloud, frame_.noise, 0);
      const double share = cloud.weight / weight_;
      all.within += share * own.within;
      all.before += share * own.before;
      all.before_hull += share * own.before_hull;
      all.behind += share * own.behind;
    }
    return all;
  }

  const Sheet* find_ground(const std::vector<Sheet>& sheets) const {
    const Sheet* ground = nullptr;
    double best = 0;
    for (const Sheet& sheet : sheets) {
      if (sheet.weight < params_.largest_remainder * weight_) continue;
      const Position all = position_of_all(sheet);
      if (all.behind > params_.largest_remainder && all.before_hull < params_.largest_remainder) continue;
      const double explained = sheet.weight / weight_ + all.before_hull - all.behind;
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
      over_ground +=
          cloud.pixels * ground.position(cloud, frame_.noise, params_.margin * ground.diameter).before_hull;
      counted[std::size_t(s)] = true;
    }
    const bool large_enough =
        2 * over_ground > own ? sheet.area >= params_.smallest_support : own >= params_.largest_remainder * pixels_;
    const bool close = sheet.weight >= ground.weight && sheet.area >= params_.smallest_support;
    if (sheet.area < params_.relative_area * ground.area && !(large_enough && !leads_to_a_support(sheet)) &&
        !(close && contact_with_supports(sheet) < 0.3 * sheet.diameter))
      return false;
    for (const int s : sheet.surfaces)
      for (const int other : touching_[std::size_t(s)]) {
        if (counted[std::size_t(other)] || roles_[std::size_t(other)] == Role::background) continue;
        counted[std::size_t(other)] = true;
        const Cloud& cloud = clouds_[std::size_t(other)];
        const Position where = sheet.position(cloud, frame_.noise, 0);
        if (where.before_hull > where.behind) standing += where.before_hull * cloud.pixels;
      }
    return standing >= params_.largest_remainder * own;
  }

  /// Which surfaces a chain of touching objects leads to from a sheet.
  std::vector<bool> reached_from(const Sheet& sheet) const {
    std::vector<bool> reached(clouds_.size(), false);
    std::vector<int> open = sheet.surfaces;
    for (const int s : open) reached[std::size_t(s)] = true;
    while (!open.empty()) {
      const int s = open.back();
      open.pop_back();
      if (roles_[std::size_t(s)] == Role::background) continue;
      for (const int other : touching_[std::size_t(s)])
        if (!reached[std::size_t(other)]) {
          reached[std::size_t(other)] = true;
          open.push_back(other);
        }
    }
    return reached;
  }

  bool leads_to_a_support(const Sheet& sheet) const {
    const std::vector<bool> reached = reached_from(sheet);
    for (std::size_t s = 0; s < reached.size(); ++s)
      if (reached[s] && roles_[s] == Role::background) return true;
    return false;
  }

  /// Metres along which what touches a sheet touches supports, too: the sides of a box do along all of it, the frame of
  /// a table with its legs does not.
  double contact_with_supports(const Sheet& sheet) const {
    std::vector<bool> side(clouds_.size(), false);
    for (const int s : sheet.surfaces)
      for (const int other : touching_[std::size_t(s)]) side[std::size_t(other)] = true;
    for (const int s : sheet.surfaces) side[std::size_t(s)] = false;
    double length = 0;
    for (const Adjacency& adjacency : surfaces_.adjacencies) {
      const auto a = std::size_t(adjacency.a), b = std::size_t(adjacency.b);
      const bool a_supports = roles_[a] == Role::background, b_supports = roles_[b] == Role::background;
      if (a_supports != b_supports && side[a_supports ? b : a])
        for (const PixelPair& pair : adjacency.border_3d) length += double(frame_.depth(pair.a)) / frame_.camera.fx;
    }
    if (std::getenv("FG_DEBUG") && !std::getenv("FG_QUIET")) fprintf(stderr, "CONTACT %s %.3f of %.3f\n", frame_.name.c_str(), length/2, sheet.diameter);
    return length / 2;  // each pixel of a border is in about two pairs
  }

  bool is_background(const Sheet& sheet) const {
    return std::all_of(sheet.surfaces.begin(), sheet.surfaces.end(),
                       [&](int s) { return roles_[std::size_t(s)] == Role::background; });
  }

  void accept(const Sheet& sheet) {
    supports_.push_back(&sheet);
    for (const int s : sheet.surfaces) roles_[std::size_t(s)] = Role::background;
  }

  /// The supports that carry what the frame is of.
  std::vector<const Sheet*> find_stages() const {
    std::vector<double> carried(supports_.size(), 0);
    for (std::size_t s = 0; s < clouds_.size(); ++s)
      if (roles_[s] == Role::object)
        if (const std::optional<std::size_t> carrier = carrier_of(clouds_[s])) carried[*carrier] += clouds_[s].weight;
    const double most = *std::max_element(carried.begin(), carried.end());
    std::vector<const Sheet*> stages;
    for (std::size_t i = 0; i < supports_.size(); ++i) {
      if (carried[i] >= 0.25 * most) stages.push_back(supports_[i]);
      if (std::getenv("FG_DEBUG") && !std::getenv("FG_QUIET"))
        fprintf(stderr, "SUPPORT %s area %.3f weight %.3f diam %.2f z %.2f n (%.2f %.2f %.2f) carried %.4f %s\n", frame_.name.c_str(), supports_[i]->area, supports_[i]->weight/weight_, supports_[i]->diameter, supports_[i]->plane.point.z(), supports_[i]->plane.normal.x(), supports_[i]->plane.normal.y(), supports_[i]->plane.normal.z(), carried[i] / weight_, carried[i] >= 0.25 * most ? "STAGE" : "");
    }
    return stages;
  }

  /// What stands on a support is before it and over it, and of those the nearest is the one; but of several planes that
  /// errors of depth bend a table into it is the one with the largest weight.
  std::optional<std::size_t> carrier_of(const Cloud& cloud) const {
    std::vector<std::size_t> below;
    std::optional<std::size_t> carrier;
    double least = 0;
    for (std::size_t i = 0; i < supports_.size(); ++i) {
      if (2 * supports_[i]->position(cloud, frame_.noise, 0).before_hull <= 1) continue;
      below.push_back(i);
      double distance = 0;
      for (const Eigen::Vector3f& p : cloud.points) distance += supports_[i]->plane.distance(p);
      if (carrier && distance >= least) continue;
      carrier = i;
      least = distance;
    }
    const std::optional<std::size_t> nearest = carrier;
    for (const std::size_t i : below)
      if (supports_[i]->weight > supports_[*carrier]->weight && continues(*supports_[i], *supports_[*nearest]))
        carrier = i;
    return carrier;
  }

  bool continues(const Sheet& sheet, const Sheet& other) const {
    return sheet.plane.normal.dot(other.plane.normal) > std::cos(15 * CV_PI / 180) &&
           std::abs(sheet.plane.distance(other.plane.point.cast<float>())) < params_.margin * sheet.diameter;
  }

  /// Whether a surface is before some stage and over it, and not in the plane of any support.
  bool is_on_one_of(const std::vector<const Sheet*>& stages, const Cloud& cloud) const {
    if (std::any_of(supports_.begin(), supports_.end(),
                    [&](const Sheet* support) { return support->has(cloud, frame_.noise); }))
      return false;
    return std::any_of(stages.begin(), stages.end(), [&](const Sheet* stage) {
      const Position where = stage->position(cloud, frame_.noise, params_.margin * stage->diameter);
      return where.before_hull > where.behind + (where.before - where.before_hull);
    });
  }

  const Frame& frame_;
  const SurfaceSet& surfaces_;
  const FigureGroundParams& params_;
  std::vector<Cloud> clouds_;
  std::vector<std::vector<int>> touching_;
  std::vector<Role> roles_;
  std::vector<const Sheet*> supports_;
  double weight_ = 0, pixels_ = 0;
};

}  // namespace

std::vector<Role> find_roles(const Frame& frame, const SurfaceSet& surfaces, const FigureGroundParams& params) {
  return FigureGround(frame, surfaces, params).roles();
}

std::vector<double> find_sizes(const Frame& frame, const SurfaceSet& surfaces, const FigureGroundParams& params) {
  std::vector<double> sizes;
  const double pixel = 1 / (frame.camera.fx * frame.camera.fy);
  for (const Surface& surface : surfaces.surfaces) {
    double size = 0;
    for (const int p : surface.pixels) {
      const double z = frame.depth(p), resolved = params.least_extent * frame.noise.at(z);
      size += z * z * pixel / std::max({1e-4 * params.min_object, resolved * resolved, 1e-12});
    }
    sizes.push_back(size);
  }
  return sizes;
}

}  // namespace gestalt
