// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "line_links.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

namespace gestalt {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float collinear_angle = pi / 6;   ///< larger angles are junctions
constexpr float search_along = 8;           ///< reach of the search lines for collinearities, line lengths
constexpr float search_corner = 1;          ///< and for junctions
constexpr std::size_t links_within = 4;     ///< kept from a line to lines of its own surface
constexpr std::size_t links_to_others = 8;  ///< and to lines of others

/// Left turn from one direction to another, in (-pi, pi]; image rows grow downwards.
float left_turn(const Eigen::Vector2f& from, const Eigen::Vector2f& to) {
  return -std::atan2(cross(from, to), from.dot(to));
}

class Linker {
 public:
  Linker(const Frame& frame, const BoundaryLines& all)
      : lines_(all.lines),
        focal_(float(std::max(frame.camera.fx, frame.camera.fy))),
        slack_(3 * std::max(0.5f, pixel_scale(frame.camera))),
        density_(float(all.lines.size()) / float(frame.depth.total())) {}

  /// The link from one line to another, if their search lines meet.
  std::optional<LineLink> link(int from, int to) const {
    const BoundaryLine &x = lines_[std::size_t(from)], &y = lines_[std::size_t(to)];
    const Eigen::Vector2f gap = y.ends[0] - x.ends[1];
    const float reach = search_along * std::max(x.length, y.length) + slack_;
    if (gap.squaredNorm() > reach * reach) return {};
    const float turn = left_turn(x.direction, y.direction);
    return std::abs(turn) < collinear_angle ? collinearity(from, to, turn, gap) : junction(from, to, turn, gap);
  }

 private:
  /// Both search lines run into the other line's end: across by no more than a share of the way.
  std::optional<LineLink> collinearity(int from, int to, float turn, const Eigen::Vector2f& gap) const {
    const BoundaryLine &x = lines_[std::size_t(from)], &y = lines_[std::size_t(to)];
    const float length = gap.norm();
    if (length > search_along * std::min(x.length, y.length) + slack_) return {};
    if (x.direction.dot(gap) < -slack_ || y.direction.dot(gap) < -slack_) return {};
    const float alpha = deviation(x.direction, gap), beta = deviation(y.direction, gap);
    if (alpha > collinear_angle || beta > collinear_angle) return {};
    const float gap_3d = longest_gap(x, y, length);
    // Chance that a line's end lies in the two triangles that the gap and both angles open.
    const float smallest = 0.02f;
    const float cost =
        1 - std::exp(-2 * density_ * gap_3d * gap_3d * std::max(alpha, smallest) * std::max(beta, smallest) / pi);
    return LineLink{from, to, turn, gap_3d, cost, 0.5f * (x.ends[1] + y.ends[0])};
  }

  /// Angle of a direction against the gap, beyond what the ends' uncertainty explains.
  float deviation(const Eigen::Vector2f& direction, const Eigen::Vector2f& gap) const {
    const float across = std::max(0.f, std::abs(cross(direction, gap)) - 0.5f * slack_);
    return std::atan2(across, std::max(direction.dot(gap), slack_));
  }

  std::optional<LineLink> junction(int from, int to, float turn, const Eigen::Vector2f& gap) const {
    const BoundaryLine &x = lines_[std::size_t(from)], &y = lines_[std::size_t(to)];
    const float sine = cross(x.direction, y.direction);
    if (std::abs(turn) > pi - collinear_angle) return {};
    const float along_x = cross(gap, y.direction) / sine, along_y = cross(gap, x.direction) / sine;
    // The corner is at x.end + along_x * x.direction = y.start + along_y * y.direction.
    if (along_x < -slack_ || along_x > search_corner * x.length + slack_) return {};
    if (-along_y < -slack_ || -along_y > search_corner * y.length + slack_) return {};
    const float gap_3d = longest_gap(x, y, gap.norm());
    const float cost = 1 - std::exp(-2 * density_ * pi * gap_3d * gap_3d);
    return LineLink{from, to, turn, gap_3d, cost, x.ends[1] + along_x * x.direction};
  }

  float longest_gap(const BoundaryLine& x, const BoundaryLine& y, float in_image) const {
    const float depth = std::min(x.points[1].z(), y.points[0].z());
    if (!(depth > 0)) return in_image;
    return std::max(in_image, (y.points[0] - x.points[1]).norm() * focal_ / depth);
  }

  const std::vector<BoundaryLine>& lines_;
  const float focal_;
  const float slack_;    ///< px; uncertainty of an end
  const float density_;  ///< lines per px^2
};

bool cheaper(const LineLink& x, const LineLink& y) {
  return std::tie(x.cost, x.gap, x.from, x.to) < std::tie(y.cost, y.gap, y.from, y.to);
}

/// The best links from one line, cheapest first.
std::vector<LineLink> links_from(int from, const std::vector<BoundaryLine>& lines, const Linker& linker) {
  std::vector<LineLink> within, to_others;
  for (int to = 0; to < int(lines.size()); ++to) {
    if (to == from || !lines[std::size_t(to)].own()) continue;
    if (const auto link = linker.link(from, to))
      (lines[std::size_t(to)].surface == lines[std::size_t(from)].surface ? within : to_others).push_back(*link);
  }
  std::sort(within.begin(), within.end(), cheaper);
  std::sort(to_others.begin(), to_others.end(), cheaper);
  within.resize(std::min(within.size(), links_within));
  to_others.resize(std::min(to_others.size(), links_to_others));
  within.insert(within.end(), to_others.begin(), to_others.end());
  std::sort(within.begin(), within.end(), cheaper);
  return within;
}

/// Where the end of a line runs into the middle of another.
class Meeting {
 public:
  explicit Meeting(const Frame& frame)
      : frame_(frame), reach_(std::max(2.f, 6 * pixel_scale(frame.camera))), shortest_(2 * reach_) {}

  float shortest_piece() const { return shortest_; }

  /// Distance in px along met from its first end, if that end of stem runs into its middle.
  std::optional<float> at(const BoundaryLine& stem, int end, const BoundaryLine& met) const {
    const Eigen::Vector2f& tip = stem.ends[std::size_t(end)];
    const float along = met.direction.dot(tip - met.ends[0]);
    if (along < shortest_ || along > met.length - shortest_) return {};
    if (std::abs(cross(met.direction, tip - met.ends[0])) > reach_) return {};
    if (std::abs(cross(met.direction, stem.direction)) < std::sin(collinear_angle)) return {};
    const Eigen::Vector3f there = met.points[0] + along / met.length * (met.points[1] - met.points[0]);
    const Eigen::Vector3f& here = stem.points[std::size_t(end)];
    const double tolerance = 3 * frame_.noise.at(here.z()) + 2 * reach_ * here.z() / frame_.camera.fx;
    if ((there - here).norm() > tolerance) return {};
    return along;
  }

 private:
  const Frame& frame_;
  const float reach_;
  const float shortest_;
};

BoundaryLine piece_of(const BoundaryLine& line, float from, float to) {
  BoundaryLine piece = line;
  for (const std::size_t end : {0, 1}) {
    const float share = (end == 0 ? from : to) / line.length;
    piece.ends[end] = line.ends[0] + share * (line.ends[1] - line.ends[0]);
    piece.points[end] = line.points[0] + share * (line.points[1] - line.points[0]);
  }
  piece.length = to - from;
  piece.support = std::max(2, int(std::lround(float(line.support) * (to - from) / line.length)));
  return piece;
}

}  // namespace

void split_where_met(const Frame& frame, BoundaryLines& all) {
  const Meeting meeting(frame);
  const std::vector<BoundaryLine>& lines = all.lines;
  std::vector<std::vector<float>> cuts(lines.size());
  tbb::parallel_for(std::size_t{0}, lines.size(), [&](std::size_t m) {
    for (const BoundaryLine& stem : lines)
      for (const int end : {0, 1}) {
        if (!stem.own() || stem.surface == lines[m].surface) continue;
        if (const auto along = meeting.at(stem, end, lines[m])) cuts[m].push_back(*along);
      }
    std::sort(cuts[m].begin(), cuts[m].end());
  });
  std::vector<BoundaryLine> pieces;
  for (std::size_t m = 0; m < lines.size(); ++m) {
    float from = 0;
    for (const float cut : cuts[m]) {
      if (cut - from < meeting.shortest_piece()) continue;
      pieces.push_back(piece_of(lines[m], from, cut));
      all.t_junctions.push_back({pieces.back().ends[1]});
      from = cut;
    }
    pieces.push_back(from > 0 ? piece_of(lines[m], from, lines[m].length) : lines[m]);
  }
  all.lines = std::move(pieces);
}

void link_lines(const Frame& frame, BoundaryLines& all) {
  const Linker linker(frame, all);
  std::vector<std::vector<LineLink>> found(all.lines.size());
  tbb::parallel_for(std::size_t{0}, all.lines.size(), [&](std::size_t from) {
    if (all.lines[from].own()) found[from] = links_from(int(from), all.lines, linker);
  });
  for (const std::vector<LineLink>& links : found)
    for (const LineLink& link : links)
      (std::abs(link.turn) < collinear_angle ? all.collinearities : all.junctions).push_back(link);
}

}  // namespace gestalt
