// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/pipeline/figure_ground.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sheet.h"

namespace gestalt {

namespace {

constexpr double largest_dent = 10;       // of find_sizes()
constexpr double same_direction = 0.966;  // cosine of 15 degrees
constexpr double widest_contact = 0.3;    // of a table's diameter, along which its frame may touch the floor

class FigureGround {
 public:
  FigureGround(const Frame& frame, const SurfaceSet& surfaces, const FigureGroundParams& params)
      : frame_(frame),
        surfaces_(surfaces),
        params_(params),
        clouds_(sample_surfaces(frame, surfaces, params.max_depth)),
        sizes_(find_sizes(frame, surfaces, params)),
        roles_(clouds_.size(), Role::object) {
    for (std::size_t s = 0; s < clouds_.size(); ++s) {
      if (clouds_[s].points.empty()) roles_[s] = Role::background;
      weight_ += clouds_[s].weight;
      pixels_ += clouds_[s].pixels;
    }
    touching_.resize(clouds_.size());
    adjacent_.resize(clouds_.size());
    for (const Adjacency& adjacency : surfaces.adjacencies) {
      adjacent_[std::size_t(adjacency.a)].push_back(&adjacency);
      adjacent_[std::size_t(adjacency.b)].push_back(&adjacency);
      if (!adjacency.border_3d.empty()) {
        touching_[std::size_t(adjacency.a)].push_back(adjacency.b);
        touching_[std::size_t(adjacency.b)].push_back(adjacency.a);
      }
    }
  }

  std::vector<Role> roles() {
    const std::vector<Sheet> sheets = find_sheets(frame_, clouds_, params_.tolerance);
    const Sheet* ground = find_ground(sheets);
    if (!ground) return roles_;
    accept(*ground);
    for (const Sheet& sheet : sheets)
      if (&sheet != ground && is_wall(sheet, *ground)) accept(sheet);
    for (const Sheet& sheet : sheets)
      if (!is_background(sheet) && is_table(sheet, *ground)) accept(sheet);
    while (const Sheet* bottom = find_bottom(sheets)) {
      accept(*bottom);
      for (const Sheet* wall : walls_around(*bottom, sheets)) accept(*wall);
    }
    const std::vector<const Sheet*> stages = find_stages();
    for (const Sheet* stage : stages)
      for (const Sheet* wall : walls_around(*stage, sheets)) accept(*wall);
    for (std::size_t s = 0; s < clouds_.size(); ++s)
      if (roles_[s] == Role::object && !is_figure(s, stages)) roles_[s] = Role::background;
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
    double over_ground = 0;
    for (const int s : sheet.surfaces) {
      const Cloud& cloud = clouds_[std::size_t(s)];
      over_ground += cloud.pixels * ground.position(cloud, frame_.noise, params_.margin * ground.diameter).before_hull;
    }
    const bool large_enough = 2 * over_ground > sheet.pixels ? sheet.area >= params_.smallest_support
                                                             : sheet.pixels >= params_.largest_remainder * pixels_;
    // A floor of many square metres may be most of the room and little of what is within reach.
    const bool close = sheet.weight >= ground.weight && sheet.area >= params_.smallest_support;
    if (sheet.area < params_.relative_area * ground.area && !(large_enough && !leads_to_a_support(sheet)) &&
        !(close && contact_with_supports(sheet) < widest_contact * sheet.diameter))
      return false;
    return standing_on(sheet) >= params_.largest_remainder * sheet.pixels;
  }

  /// Pixels of the objects that touch a sheet and are over it.
  double standing_on(const Sheet& sheet) const {
    double standing = 0;
    std::vector<bool> counted(clouds_.size(), false);
    for (const int s : sheet.surfaces) counted[std::size_t(s)] = true;
    for (const int s : sheet.surfaces)
      for (const int other : touching_[std::size_t(s)]) {
        if (counted[std::size_t(other)] || roles_[std::size_t(other)] == Role::background) continue;
        counted[std::size_t(other)] = true;
        const Cloud& cloud = clouds_[std::size_t(other)];
        const Position where = sheet.position(cloud, frame_.noise, 0);
        if (where.before_hull > where.behind) standing += where.before_hull * cloud.pixels;
      }
    return standing;
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

  /// The supports that carry what the frame is of: the one with the most on it within reach, others that carry nearly
  /// as much, but not the floor under a table.
  std::vector<const Sheet*> find_stages() const {
    std::vector<double> carried(supports_.size(), 0);
    for (std::size_t s = 0; s < clouds_.size(); ++s)
      if (roles_[s] == Role::object)
        if (const std::optional<std::size_t> carrier = carrier_of(clouds_[s])) carried[*carrier] += clouds_[s].weight;
    auto most = std::size_t(std::max_element(carried.begin(), carried.end()) - carried.begin());
    // The floor carries a table, too, and with it all that is on the table.
    for (std::size_t i = 0; i < supports_.size(); ++i)
      if (carried[i] >= params_.largest_remainder * weight_ && supports_[i]->weight > supports_[most]->weight &&
          stands_on(*supports_[i], *supports_[most], params_.margin))
        most = i;
    std::vector<const Sheet*> stages{supports_[most]};
    for (std::size_t i = 0; i < supports_.size(); ++i)
      if (i != most && carried[i] >= params_.relative_area * carried[most] &&
          supports_[i]->weight >= params_.largest_remainder * weight_ &&
          !stands_on(*stages.front(), *supports_[i], params_.margin))
        stages.push_back(supports_[i]);
    return stages;
  }

  /// Whether a surface is before a support and over it, or nearly so.
  bool is_on(const Sheet& support, const Cloud& cloud, double margin) const {
    const Position where = support.position(cloud, frame_.noise, margin * support.diameter);
    return where.before_hull > where.behind + (where.before - where.before_hull);
  }
  bool is_on(const Sheet& support, const Cloud& cloud) const { return is_on(support, cloud, params_.margin); }

  bool stands_on(const Sheet& sheet, const Sheet& support, double margin) const {
    double on = 0;
    for (const int s : sheet.surfaces)
      if (is_on(support, clouds_[std::size_t(s)], margin)) on += clouds_[std::size_t(s)].pixels;
    return 2 * on > sheet.pixels;
  }

  /// What stands on a support is before it and over it, and of those the nearest is the one; but of several planes that
  /// errors of depth bend a table into it is the one with the largest weight.
  std::optional<std::size_t> carrier_of(const Cloud& cloud) const {
    std::vector<std::size_t> below;
    std::optional<std::size_t> carrier;
    double least = 0;
    for (std::size_t i = 0; i < supports_.size(); ++i) {
      if (!is_on(*supports_[i], cloud)) continue;
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
    return sheet.plane.normal.dot(other.plane.normal) > same_direction &&
           std::abs(sheet.plane.distance(other.plane.point.cast<float>())) < params_.margin * sheet.diameter;
  }

  /// Whether a surface is on a stage and neither in the plane of a support nor a dent of the stage.
  bool is_figure(std::size_t s, const std::vector<const Sheet*>& stages) const {
    const Cloud& cloud = clouds_[s];
    if (std::any_of(supports_.begin(), supports_.end(),
                    [&](const Sheet* support) { return support->has(cloud, frame_.noise); }))
      return false;
    return std::any_of(stages.begin(), stages.end(), [&](const Sheet* stage) { return is_on(*stage, cloud); }) &&
           std::none_of(stages.begin(), stages.end(), [&](const Sheet* stage) { return is_dent(s, *stage); });
  }

  /// Whether a surface is what errors of depth make of a stage: low, small, and surrounded by it.
  bool is_dent(std::size_t s, const Sheet& stage) const {
    if (sizes_[s] > largest_dent) return false;
    const Cloud& cloud = clouds_[s];
    const auto high = std::count_if(cloud.points.begin(), cloud.points.end(), [&](const Eigen::Vector3f& p) {
      return std::abs(stage.plane.distance(p)) > 2 * stage.tolerance * frame_.noise.at(double(p.z()));
    });
    if (double(high) > 0.1 * double(cloud.points.size())) return false;
    std::size_t around = 0, flush = 0;
    for (const Adjacency* adjacency : adjacent_[s]) {
      around += adjacency->border_2d.size();
      if (stage.has(clouds_[std::size_t(adjacency->a == int(s) ? adjacency->b : adjacency->a)], frame_.noise))
        flush += adjacency->border_3d.size();
    }
    return 2 * flush > around;
  }

  // ------------------------------------------------------------------------------------------------ open containers

  /// Whether a sheet is a wall of a container: it rises from the bottom along most of it, with all of the bottom on one
  /// side. The faces of a box do not: the box's other faces lie behind them.
  bool is_wall_of(const Sheet& wall, const Sheet& bottom) const {
    const Eigen::Vector3d along = wall.plane.normal.cross(bottom.plane.normal);
    if (along.norm() < 0.5) return false;
    if (wall.extent(along.normalized()) < 0.7 * bottom.extent(along.normalized())) return false;
    // The near wall hides a part of the bottom.
    if (!stands_on(wall, bottom, 3 * params_.margin)) return false;
    Position of_bottom;
    for (const int s : bottom.surfaces) {
      const Cloud& cloud = clouds_[std::size_t(s)];
      const Position where = wall.position(cloud, frame_.noise, 0);
      of_bottom.before += where.before * cloud.pixels / bottom.pixels;
      of_bottom.behind += where.behind * cloud.pixels / bottom.pixels;
    }
    if (std::min(of_bottom.before, of_bottom.behind) > 0.05) return false;
    double behind = 0;
    std::vector<bool> counted(clouds_.size(), false);
    for (const int s : wall.surfaces)
      for (const int other : touching_[std::size_t(s)]) {
        const auto t = std::size_t(other);
        if (counted[t] || roles_[t] == Role::background) continue;
        counted[t] = true;
        const Position where = wall.position(clouds_[t], frame_.noise, 0);
        if (2 * where.behind > 1) behind += clouds_[t].pixels;
      }
    return behind < 0.2 * wall.pixels;
  }

  /// The walls of a container with this bottom, of which two are to be seen from within; else none: one plane beside a
  /// table may be a face of something large.
  std::vector<const Sheet*> walls_around(const Sheet& bottom, const std::vector<Sheet>& sheets) const {
    std::vector<const Sheet*> walls;
    for (const Sheet& sheet : sheets)
      if (&sheet != &bottom && !is_background(sheet) && is_wall_of(sheet, bottom)) walls.push_back(&sheet);
    for (const Sheet* a : walls)
      for (const Sheet* b : walls)
        if (a->plane.normal.dot(b->plane.normal) < std::cos(CV_PI / 4)) return walls;
    return {};
  }

  /// The sides of a container see each other as it sees them; its bottom is the one that most stands on.
  const Sheet* find_bottom(const std::vector<Sheet>& sheets) const {
    const Sheet* bottom = nullptr;
    double most = 0;
    for (const Sheet& sheet : sheets) {
      if (is_background(sheet) || sheet.area < params_.smallest_support ||
          sheet.weight < params_.largest_remainder * weight_ || walls_around(sheet, sheets).empty())
        continue;
      const double standing = standing_on(sheet);
      if (standing <= std::max(most, params_.largest_remainder * sheet.pixels)) continue;
      bottom = &sheet;
      most = standing;
    }
    return bottom;
  }

  const Frame& frame_;
  const SurfaceSet& surfaces_;
  const FigureGroundParams& params_;
  std::vector<Cloud> clouds_;
  std::vector<std::vector<const Adjacency*>> adjacent_;
  std::vector<std::vector<int>> touching_;  // those of them with a border in space
  std::vector<double> sizes_;
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
