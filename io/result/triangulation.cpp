// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Ear clipping of polygons with holes. Each hole becomes part of the ring around it by a bridge that is walked there
// and back (Eberly, "Triangulation by Ear Clipping").

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "gestalt/core/base/error.h"
#include "gestalt/io/result/parametric_surface.h"

namespace gestalt {

namespace {

using Point = Eigen::Vector2d;
using Triangle = std::array<int, 3>;
using Ring = std::vector<int>;  // indices of vertices, in order around it

/// Takes the cost of a step, in vertices that it looks at.
void spend(std::size_t tests, TriangulationBudget& budget) {
  if (tests > budget.tests) throw InputError("the outlines are too tangled to be triangulated");
  budget.tests -= tests;
}

/// Twice the area of a triangle, positive when it turns counter-clockwise.
double area(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool in_triangle(const Point& p, const Point& a, const Point& b, const Point& c) {
  return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
}

class Polygons {
 public:
  Polygons(const std::vector<TrimmingOutline>& outlines, TriangulationBudget& budget) : budget_(budget) {
    std::vector<Ring> holes;
    for (const TrimmingOutline& outline : outlines) {
      Ring ring;
      for (const Point& vertex : outline.vertices) {
        points_.push_back(vertex);
        ring.push_back(int(points_.size()) - 1);
      }
      remove_repetitions(ring);
      if (ring.size() < 3) continue;
      if ((signed_area(ring) < 0) != outline.hole) std::reverse(ring.begin(), ring.end());
      (outline.hole ? holes : rings_).push_back(std::move(ring));
    }
    // From the right to the left, so that a hole's bridge never meets one that is still to come.
    std::stable_sort(holes.begin(), holes.end(),
                     [&](const Ring& a, const Ring& b) { return at(*rightmost(a)).x() > at(*rightmost(b)).x(); });
    for (const Ring& hole : holes) bridge(hole);
  }

  std::vector<Triangle> triangles() const {
    std::vector<Triangle> all;
    for (const Ring& ring : rings_) clip_ears(ring, all);
    return all;
  }

 private:
  const Point& at(int vertex) const { return points_[std::size_t(vertex)]; }

  void remove_repetitions(Ring& ring) const {
    ring.erase(std::unique(ring.begin(), ring.end(), [&](int a, int b) { return at(a) == at(b); }), ring.end());
    while (ring.size() > 1 && at(ring.front()) == at(ring.back())) ring.pop_back();
  }

  double signed_area(const Ring& ring) const {
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
      sum += area(at(ring[0]), at(ring[i]), at(ring[(i + 1) % ring.size()]));
    return sum;
  }

  Ring::const_iterator rightmost(const Ring& ring) const {
    return std::max_element(ring.begin(), ring.end(), [&](int a, int b) { return at(a).x() < at(b).x(); });
  }

  bool contains(const Ring& ring, const Point& p) const {
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = at(ring[i]), &b = at(ring[(i + 1) % ring.size()]);
      if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
        inside = !inside;
    }
    return inside;
  }

  /// Place in the ring that the hole's rightmost vertex m sees to its right.
  std::optional<std::size_t> visible_vertex(const Ring& ring, const Point& m) const {
    double nearest = std::numeric_limits<double>::infinity();
    std::optional<std::size_t> chosen;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t next = (i + 1) % ring.size();
      const Point &a = at(ring[i]), &b = at(ring[next]);
      if (std::min(a.y(), b.y()) > m.y() || std::max(a.y(), b.y()) < m.y()) continue;
      const double x =
          a.y() == b.y() ? std::min(a.x(), b.x()) : a.x() + (b.x() - a.x()) * (m.y() - a.y()) / (b.y() - a.y());
      if (x < m.x() || x >= nearest) continue;
      nearest = x;
      chosen = a.x() > b.x() ? i : next;
    }
    if (!chosen) return chosen;
    // A reflex vertex within the triangle of m, its horizon and the end of that edge hides the end: the one at the
    // smallest angle to the horizon is seen.
    const Point horizon(nearest, m.y()), end = at(ring[*chosen]);
    const auto steepness = [&](const Point& p) { return std::abs(p.y() - m.y()) / std::max(p.x() - m.x(), 1e-300); };
    const bool above = end.y() > m.y();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& p = at(ring[i]);
      if (p.x() <= m.x() || p == end) continue;
      if (!(above ? in_triangle(p, m, horizon, end) : in_triangle(p, m, end, horizon))) continue;
      if (steepness(p) < steepness(at(ring[*chosen]))) chosen = i;
    }
    // Bridges have made several vertices of one place: the right one has m in its own sector.
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (at(ring[i]) == at(ring[*chosen]) && in_sector(ring, i, m)) return i;
    return chosen;
  }

  /// Whether a point lies between the two edges of a vertex, on the inside of the ring.
  bool in_sector(const Ring& ring, std::size_t i, const Point& m) const {
    const std::size_t n = ring.size();
    const Point &a = at(ring[(i + n - 1) % n]), &b = at(ring[i]), &c = at(ring[(i + 1) % n]);
    const bool left_of_both = area(a, b, m) > 0 && area(b, c, m) > 0,
               left_of_one = area(a, b, m) > 0 || area(b, c, m) > 0;
    return area(a, b, c) > 0 ? left_of_both : left_of_one;
  }

  void bridge(const Ring& hole) {
    const auto start = rightmost(hole);
    for (Ring& ring : rings_) {
      spend(ring.size(), budget_);
      if (!contains(ring, at(*start))) continue;
      const auto place = visible_vertex(ring, at(*start));
      if (!place) continue;
      spend(3 * ring.size(), budget_);
      Ring detour(start, hole.end());
      detour.insert(detour.end(), hole.begin(), start + 1);
      detour.push_back(ring[*place]);
      ring.insert(ring.begin() + std::ptrdiff_t(*place) + 1, detour.begin(), detour.end());
      return;
    }
  }

  bool is_ear(const Ring& ring, std::size_t i) const {
    const std::size_t n = ring.size();
    const Point &a = at(ring[(i + n - 1) % n]), &b = at(ring[i]), &c = at(ring[(i + 1) % n]);
    if (area(a, b, c) <= 0) return false;
    for (std::size_t k = 0; k < n; ++k) {
      const Point& p = at(ring[k]);
      if (p == a || p == b || p == c || !in_triangle(p, a, b, c)) continue;
      if (area(at(ring[(k + n - 1) % n]), p, at(ring[(k + 1) % n])) <= 0) return false;  // reflex
    }
    return true;
  }

  void clip_ears(Ring ring, std::vector<Triangle>& triangles) const {
    std::size_t i = 0, misses = 0;
    while (ring.size() > 2) {
      const std::size_t n = ring.size();
      const int before = ring[(i + n - 1) % n], here = ring[i], after = ring[(i + 1) % n];
      const double size = area(at(before), at(here), at(after));
      const bool stuck = misses >= n;  // the ring crosses itself
      spend(n, budget_);
      if (is_ear(ring, i) || size == 0 || stuck) {
        if (size > 0) triangles.push_back({before, here, after});
        ring.erase(ring.begin() + std::ptrdiff_t(i));
        misses = 0;
        i = i % ring.size();
      } else {
        i = (i + 1) % n;
        ++misses;
      }
    }
  }

  TriangulationBudget& budget_;
  std::vector<Point> points_;
  std::vector<Ring> rings_;
};

/// Splits the edges of triangles until a surface is nowhere farther from them than the tolerance. Whether an edge is
/// split depends on the edge alone, so that both triangles beside it do the same.
class Refinement {
 public:
  Refinement(const TrimmedSurface& surface, double tolerance, TriangulationBudget& budget)
      : surface_(surface), tolerance_(tolerance), budget_(budget) {}

  Mesh run(const std::vector<Triangle>& triangles) {
    for (const TrimmingOutline& outline : surface_.outlines)
      for (const Point& p : outline.vertices) add(p);
    for (const Triangle& t : triangles) split(t, 0);
    drop_unused();
    return std::move(mesh_);
  }

 private:
  int add(const Point& parameters) {
    parameters_.push_back(parameters);
    mesh_.vertices.push_back(surface_.point(parameters));
    return int(parameters_.size()) - 1;
  }

  /// The vertex in the middle of an edge, or none where the edge is near enough to the surface.
  std::optional<int> middle(int a, int b) {
    const auto key = std::minmax(a, b);
    if (const auto known = middles_.find(key); known != middles_.end()) return known->second;
    const Point p = parameters_[std::size_t(key.first)], q = parameters_[std::size_t(key.second)];
    const Eigen::Vector3d from = mesh_.vertices[std::size_t(key.first)], to = mesh_.vertices[std::size_t(key.second)];
    std::optional<int> vertex;
    for (const double share : {0.5, 0.25, 0.75})
      if ((surface_.point(p + share * (q - p)) - (from + share * (to - from))).norm() > tolerance_) {
        vertex = add((p + q) / 2);
        break;
      }
    middles_.emplace(key, vertex);
    return vertex;
  }

  void split(const Triangle& t, int depth) {
    constexpr int deepest = 8;
    std::array<std::optional<int>, 3> m;  // m[k] lies opposite of t[k]
    if (depth < deepest)
      for (std::size_t k = 0; k < 3; ++k) m[k] = middle(t[(k + 1) % 3], t[(k + 2) % 3]);
    const auto count = std::count_if(m.begin(), m.end(), [](const auto& v) { return v.has_value(); });
    if (count == 0) {
      if (budget_.triangles == 0)
        throw InputError("more than " + std::to_string(TriangulationBudget::most_triangles) +
                         " triangles are needed; allow a larger tolerance");
      --budget_.triangles;
      mesh_.triangles.push_back(t);
      return;
    }
    if (count == 3) {
      for (std::size_t k = 0; k < 3; ++k) split({t[k], *m[(k + 2) % 3], *m[(k + 1) % 3]}, depth + 1);
      split({*m[0], *m[1], *m[2]}, depth + 1);
      return;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      const auto &ab = m[(k + 2) % 3], &bc = m[k], &ca = m[(k + 1) % 3];
      if (count == 1 && ab) {
        split({a, *ab, c}, depth + 1);
        split({*ab, b, c}, depth + 1);
        return;
      }
      if (count == 2 && ab && ca && !bc) {
        split({a, *ab, *ca}, depth + 1);
        split({*ab, b, *ca}, depth + 1);
        split({b, c, *ca}, depth + 1);
        return;
      }
    }
  }

  void drop_unused() {
    std::vector<int> number(mesh_.vertices.size(), -1);
    std::vector<Eigen::Vector3d> used;
    for (Triangle& t : mesh_.triangles)
      for (int& vertex : t) {
        int& known = number[std::size_t(vertex)];
        if (known < 0) {
          known = int(used.size());
          used.push_back(mesh_.vertices[std::size_t(vertex)]);
        }
        vertex = known;
      }
    mesh_.vertices = std::move(used);
  }

  const TrimmedSurface& surface_;
  const double tolerance_;
  TriangulationBudget& budget_;
  std::vector<Point> parameters_;
  std::map<std::pair<int, int>, std::optional<int>> middles_;
  Mesh mesh_;
};

}  // namespace

std::vector<Triangle> triangulate(const std::vector<TrimmingOutline>& outlines, TriangulationBudget& budget) {
  return Polygons(outlines, budget).triangles();
}

Mesh triangulate(const TrimmedSurface& surface, double tolerance, TriangulationBudget& budget) {
  return Refinement(surface, tolerance, budget).run(triangulate(surface.outlines, budget));
}

}  // namespace gestalt
