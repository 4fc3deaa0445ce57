// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "line_split.h"

#include <algorithm>
#include <cmath>

namespace gestalt {

namespace {

using Chain = std::vector<Eigen::Vector2f>;

struct FittedLine {
  Eigen::Vector2f centre;
  Eigen::Vector2f direction;

  float deviation(const Eigen::Vector2f& p) const {
    const Eigen::Vector2f d = p - centre;
    return std::abs(direction.x() * d.y() - direction.y() * d.x());
  }
  Eigen::Vector2f foot(const Eigen::Vector2f& p) const { return centre + direction * direction.dot(p - centre); }
};

/// Least-squares line through count points from first on; points at both ends, where corners are rounded, count little:
/// they are left out where enough others are there.
FittedLine fit(const Chain& chain, std::size_t first, std::size_t count) {
  const std::size_t trim = std::min<std::size_t>(2, count / 8);
  const Eigen::Vector2f& origin = chain[(first + count / 2) % chain.size()];
  Eigen::Vector2f sum = Eigen::Vector2f::Zero();
  float xx = 0, xy = 0, yy = 0;
  for (std::size_t i = trim; i < count - trim; ++i) {
    const Eigen::Vector2f p = chain[(first + i) % chain.size()] - origin;
    sum += p;
    xx += p.x() * p.x(), xy += p.x() * p.y(), yy += p.y() * p.y();
  }
  const auto n = float(count - 2 * trim);
  const Eigen::Vector2f mean = sum / n;
  xx -= n * mean.x() * mean.x(), xy -= n * mean.x() * mean.y(), yy -= n * mean.y() * mean.y();
  const float angle = 0.5f * std::atan2(2 * xy, xx - yy);
  Eigen::Vector2f direction(std::cos(angle), std::sin(angle));
  const Eigen::Vector2f along = chain[(first + count - 1) % chain.size()] - chain[first % chain.size()];
  if (direction.dot(along) < 0) direction = -direction;
  return {origin + mean, direction};
}

/// Index of the point farthest from a given one; the first of equals.
std::size_t farthest_point(const Chain& chain, std::size_t from) {
  std::size_t best = from;
  float reached = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const float distance = (chain[i] - chain[from]).squaredNorm();
    if (distance > reached) reached = distance, best = i;
  }
  return best;
}

/// Appends the break points of the piece from first to last (both inclusive, last may run past the chain's end),
/// without its last.
void split(const Chain& chain, std::size_t first, std::size_t last, float tolerance, std::vector<std::size_t>& breaks) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    const Eigen::Vector2f& start = chain[a % chain.size()];
    const Eigen::Vector2f along = chain[b % chain.size()] - start;
    const float length = along.norm();
    std::size_t worst = a;
    float deviation = tolerance;
    for (std::size_t i = a + 1; i < b; ++i) {
      const Eigen::Vector2f d = chain[i % chain.size()] - start;
      const float off = length > 0 ? std::abs(along.x() * d.y() - along.y() * d.x()) / length : d.norm();
      if (off > deviation) deviation = off, worst = i;
    }
    if (worst == a) {
      breaks.push_back(a);
    } else {
      open.emplace_back(worst, b);
      open.emplace_back(a, worst);
    }
  }
}

bool one_line(const Chain& chain, std::size_t first, std::size_t count, float tolerance) {
  const FittedLine line = fit(chain, first, count);
  const Eigen::Vector2f &start = chain[first % chain.size()], &end = chain[(first + count - 1) % chain.size()];
  const float reach = (end - start).norm();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2f& p = chain[(first + i) % chain.size()];
    const float along = line.direction.dot(p - start);
    // A chain that turns back fits a line too, but is two.
    if (line.deviation(p) > tolerance || along < -tolerance || along > reach + tolerance) return false;
  }
  return true;
}

}  // namespace

std::vector<ChainLine> split_into_lines(const Chain& chain, float tolerance) {
  if (chain.size() < 2) return {};
  const std::size_t a = farthest_point(chain, 0), b = farthest_point(chain, a), n = chain.size();
  if (a == b) return {};
  const std::size_t first = std::min(a, b), second = std::max(a, b);
  std::vector<std::size_t> breaks;
  split(chain, first, second, tolerance, breaks);
  split(chain, second, first + n, tolerance, breaks);

  struct Piece {
    std::size_t first, last;
  };
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    const Piece next{breaks[i], i + 1 < breaks.size() ? breaks[i + 1] : first + n};
    if (!pieces.empty() && one_line(chain, pieces.back().first, next.last - pieces.back().first + 1, tolerance))
      pieces.back().last = next.last;
    else
      pieces.push_back(next);
  }
  if (pieces.size() > 2 &&
      one_line(chain, pieces.back().first, pieces.front().last + n - pieces.back().first + 1, tolerance)) {
    pieces.front() = {pieces.back().first, pieces.front().last + n};
    pieces.pop_back();
  }

  std::vector<ChainLine> lines;
  for (const Piece& piece : pieces) {
    const std::size_t count = piece.last - piece.first + 1;
    const FittedLine line = fit(chain, piece.first, count);
    lines.push_back({piece.first % n, count, {line.foot(chain[piece.first % n]), line.foot(chain[piece.last % n])}});
  }
  return lines;
}

}  // namespace gestalt
