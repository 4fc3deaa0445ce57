// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/closure.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <queue>
#include <set>
#include <tuple>

#include "line_links.h"

namespace gestalt {

namespace {

constexpr std::size_t most_seeds = 256;
constexpr int most_visited = 256;
constexpr int most_closure_lines = 24;
constexpr float most_gap = 2;        ///< gaps to lines
constexpr float right_turn = 0.17f;  ///< rad; contours of real surfaces waver
constexpr float link_cost = 1e-3f;   ///< of each link, so that of two equal ways the one of fewer lines is taken
constexpr float two_pi = 2 * std::numbers::pi_v<float>;

/// The links as a graph: those from each line, of both kinds.
class LinkGraph {
 public:
  LinkGraph(const Frame& frame, const BoundaryLines& all)
      : lines(all.lines), slack(3 * std::max(0.5f, pixel_scale(frame.camera))), links_(all.lines.size()) {
    for (const auto* kind : {&all.collinearities, &all.junctions})
      for (const LineLink& link : *kind)
        if (link.turn > -right_turn) links_[std::size_t(link.from)].push_back(&link);
  }

  const std::vector<const LineLink*>& from(int line) const { return links_[std::size_t(line)]; }

  /// The cheapest links between lines of two surfaces.
  std::vector<const LineLink*> seeds() const {
    std::vector<const LineLink*> seeds;
    for (const auto& links : links_)
      for (const LineLink* link : links)
        if (line(link->from).surface != line(link->to).surface) seeds.push_back(link);
    const auto cheaper = [](const LineLink* x, const LineLink* y) {
      return std::tie(x->cost, x->gap, x->from, x->to) < std::tie(y->cost, y->gap, y->from, y->to);
    };
    std::sort(seeds.begin(), seeds.end(), cheaper);
    seeds.resize(std::min(seeds.size(), most_seeds));
    return seeds;
  }

  const BoundaryLine& line(int i) const { return lines[std::size_t(i)]; }

  const std::vector<BoundaryLine>& lines;
  const float slack;  ///< px; uncertainty of a line's end

 private:
  std::vector<std::vector<const LineLink*>> links_;
};

/// Shortest way from the line that a link goes to back to the one that it comes from.
class ClosureSearch {
 public:
  ClosureSearch(const LinkGraph& graph, const LineLink& seed)
      : graph_(graph), seed_(seed), states_(graph.lines.size()) {}

  /// The lines of the way, seed.to first and seed.from last; empty when there is none.
  std::vector<int> run() {
    states_[std::size_t(seed_.to)] = {0, seed_.turn, -1, 1, false};
    open_.emplace(0.f, seed_.to);
    for (int visited = 0; !open_.empty() && visited < most_visited;) {
      const int i = open_.top().second;
      open_.pop();
      if (state(i).closed) continue;
      state(i).closed = true;
      ++visited;
      if (i == seed_.from) return way_to(i);
      if (state(i).count < most_closure_lines)
        for (const LineLink* link : graph_.from(i)) relax(*link);
    }
    return {};
  }

 private:
  struct State {
    float cost = std::numeric_limits<float>::infinity();
    float turn = 0;   ///< so far, from the direction of seed.from
    int before = -1;  ///< line on the way
    int count = 0;    ///< lines on the way
    bool closed = false;
  };

  void relax(const LineLink& link) {
    const State& here = state(link.from);
    State& there = state(link.to);
    const float cost = here.cost + link.cost + link_cost, turn = here.turn + link.turn;
    if (there.closed || cost >= there.cost || turn > two_pi + right_turn || !convex(link.to)) return;
    if (link.to == seed_.from && std::abs(turn - two_pi) > right_turn) return;
    there = {cost, turn, link.from, here.count + 1, false};
    open_.emplace(cost, link.to);
  }

  /// A line of a convex contour is on the left of the seed's lines.
  bool convex(int i) const {
    for (const int s : {seed_.from, seed_.to}) {
      if (i == s) continue;
      const BoundaryLine &own = graph_.line(s), &line = graph_.line(i);
      for (const Eigen::Vector2f& end : line.ends)
        if (cross(own.direction, end - own.ends[0]) > right_turn * (end - own.ends[0]).norm() + graph_.slack)
          return false;
    }
    return true;
  }

  std::vector<int> way_to(int i) const {
    std::vector<int> way;
    for (; i >= 0; i = states_[std::size_t(i)].before) way.push_back(i);
    std::reverse(way.begin(), way.end());
    return way;
  }

  State& state(int i) { return states_[std::size_t(i)]; }

  const LinkGraph& graph_;
  const LineLink& seed_;
  std::vector<State> states_;
  /// (cost, line), the cheapest on top.
  std::priority_queue<std::pair<float, int>, std::vector<std::pair<float, int>>, std::greater<>> open_;
};

/// Twice the area on the polygon's left.
float signed_area(const std::vector<Eigen::Vector2f>& polygon) {
  float area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    area -= cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  return area;
}

bool segments_cross(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Eigen::Vector2f& c,
                    const Eigen::Vector2f& d) {
  return cross(b - a, c - a) * cross(b - a, d - a) < 0 && cross(d - c, a - c) * cross(d - c, b - c) < 0;
}

bool crosses_itself(const std::vector<Eigen::Vector2f>& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && segments_cross(polygon[i], polygon[i + 1], polygon[j], polygon[(j + 1) % n])) return true;
  return false;
}

/// The contour along these lines, from the one in front; none when it is not a closed convex contour of two surfaces
/// with enough line for its gaps.
std::optional<Closure> contour_along(std::vector<int> way, const LinkGraph& graph) {
  // The same contour has the same first line, whichever link it was found from.
  std::rotate(way.begin(), std::min_element(way.begin(), way.end()), way.end());
  Closure closure{std::move(way), {}, 0, 0, 0, {}};
  std::set<int> surfaces;
  for (std::size_t i = 0; i < closure.lines.size(); ++i) {
    const BoundaryLine& line = graph.line(closure.lines[i]);
    closure.outline.insert(closure.outline.end(), line.ends.begin(), line.ends.end());
    closure.line_length += line.length;
    surfaces.insert(line.surface);
    const int next = closure.lines[(i + 1) % closure.lines.size()];
    for (const LineLink* link : graph.from(closure.lines[i]))
      if (link->to == next) closure.gap_length += link->gap, closure.cost += link->cost;
  }
  if (closure.lines.size() < 3 || surfaces.size() < 2 || closure.gap_length > most_gap * closure.line_length) return {};
  if (crosses_itself(closure.outline) || !(signed_area(closure.outline) > 0)) return {};
  for (const int surface : surfaces) closure.parts.push_back({surface, 0, 0});
  for (const int i : closure.lines)
    for (Closure::Part& part : closure.parts)
      if (part.surface == graph.line(i).surface) part.line_length += graph.line(i).length;
  return closure;
}

bool encloses(const std::vector<Eigen::Vector2f>& polygon, const Eigen::Vector2f& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Eigen::Vector2f &a = polygon[i], &b = polygon[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x())
      inside = !inside;
  }
  return inside;
}

/// Estimated on an even sample of the pixels.
float share_inside(const std::vector<Eigen::Vector2f>& polygon, const std::vector<int>& pixels, int width) {
  constexpr std::size_t sample = 256;
  const std::size_t n = std::min(sample, pixels.size());
  std::size_t inside = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const int pixel = pixels[i * pixels.size() / n];
    const int u = pixel % width, v = pixel / width;
    inside += encloses(polygon, {float(u), float(v)}) ? 1 : 0;
  }
  return float(inside) / float(n);
}

}  // namespace

std::vector<Closure> find_closures(const Frame& frame, const SurfaceSet& surfaces, const BoundaryLines& lines) {
  const LinkGraph graph(frame, lines);
  const std::vector<const LineLink*> seeds = graph.seeds();
  std::vector<std::optional<Closure>> found(seeds.size());
  tbb::parallel_for(std::size_t{0}, seeds.size(), [&](std::size_t i) {
    std::vector<int> way = ClosureSearch(graph, *seeds[i]).run();
    if (!way.empty()) found[i] = contour_along(std::move(way), graph);
  });
  std::vector<Closure> closures;
  std::set<std::vector<int>> known;
  for (std::optional<Closure>& closure : found)
    if (closure && known.insert(closure->lines).second) closures.push_back(std::move(*closure));
  tbb::parallel_for(std::size_t{0}, closures.size(), [&](std::size_t i) {
    for (Closure::Part& part : closures[i].parts)
      part.inside =
          share_inside(closures[i].outline, surfaces.surfaces[std::size_t(part.surface)].pixels, surfaces.labels.cols);
  });
  std::sort(closures.begin(), closures.end(),
            [](const Closure& x, const Closure& y) { return std::tie(x.cost, x.lines) < std::tie(y.cost, y.lines); });
  return closures;
}

}  // namespace gestalt
