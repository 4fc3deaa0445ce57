// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/boundary_lines.h"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "line_links.h"
#include "line_split.h"

namespace gestalt {

namespace {

constexpr std::size_t most_lines = 1500;

/// Lengths in pixels for the frame's focal length.
struct Scale {
  float factor;
  explicit Scale(const Frame& frame) : factor(pixel_scale(frame.camera)) {}
  float tolerance() const { return std::max(1.2f, 1.9f * factor); }
  float shortest() const { return std::max(5.f, 8 * factor); }
  int reach() const { return std::max(4, int(std::lround(24 * factor))); }
};

class LineMaker {
 public:
  LineMaker(const Frame& frame, const SurfaceSet& surfaces) : frame_(frame), surfaces_(surfaces), scale_(frame) {}

  void append(int surface, const Contour& contour, std::vector<BoundaryLine>& lines) const {
    std::vector<Eigen::Vector2f> chain;
    chain.reserve(contour.pixels.size());
    for (const int pixel : contour.pixels) chain.push_back(position(pixel));
    for (const ChainLine& piece : split_into_lines(chain, scale_.tolerance())) {
      const Eigen::Vector2f along = piece.ends[1] - piece.ends[0];
      const float length = along.norm();
      if (length < scale_.shortest()) continue;
      BoundaryLine line{surface, piece.ends, {}, along / length, length, int(piece.count), Beyond::nothing};
      line.points = points_of(surface, contour, piece);
      line.beyond = beyond(line, contour, piece);
      lines.push_back(line);
    }
  }

 private:
  Eigen::Vector2f position(int pixel) const {
    const int u = pixel % frame_.width(), v = pixel / frame_.width();
    return {float(u), float(v)};
  }

  /// count numbers evenly over a piece, as pixels of the contour.
  template <class Visit>
  static void sample(const Contour& contour, const ChainLine& piece, std::size_t count, const Visit& visit) {
    const std::size_t n = std::min(count, piece.count);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t offset = n > 1 ? i * (piece.count - 1) / (n - 1) : 0;
      visit(contour.pixels[(piece.first + offset) % contour.pixels.size()]);
    }
  }

  /// The pixels' points are put on the surface first, as depth is least certain on contours.
  std::array<Eigen::Vector3f, 2> points_of(int surface, const Contour& contour, const ChainLine& piece) const {
    const SurfaceModel& model = *surfaces_.surfaces[std::size_t(surface)].model;
    std::vector<Eigen::Vector3f> points;
    sample(contour, piece, 32, [&](int pixel) {
      if (frame_.valid(pixel)) points.push_back(model.foot(frame_.point(pixel)).point);
    });
    if (points.empty()) return {Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    for (const Eigen::Vector3f& p : points) mean += p / float(points.size());
    Eigen::Matrix3f squares = Eigen::Matrix3f::Zero();
    for (const Eigen::Vector3f& p : points) squares += (p - mean) * (p - mean).transpose();
    const Eigen::Vector3f direction = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f>(squares).eigenvectors().col(2);
    const auto foot = [&](const Eigen::Vector3f& p) -> Eigen::Vector3f {
      return mean + direction * direction.dot(p - mean);
    };
    return {foot(points.front()), foot(points.back())};
  }

  /// What most of the line's pixels have beyond them.
  Beyond beyond(const BoundaryLine& line, const Contour& contour, const ChainLine& piece) const {
    std::array<int, 5> votes{};
    sample(contour, piece, 16, [&](int pixel) { ++votes[std::size_t(beyond(line, pixel))]; });
    return Beyond(std::max_element(votes.begin(), votes.end()) - votes.begin());
  }

  /// Walks outwards, over the shadow that the sensor may have there, to the next pixel of something else. The pixel
  /// right beside the contour is skipped: its depth may be mixed.
  Beyond beyond(const BoundaryLine& line, int pixel) const {
    const Eigen::Vector2f start = position(pixel);
    const Eigen::Vector2f outwards(-line.direction.y(), line.direction.x());
    for (int step = 2; step <= scale_.reach(); ++step) {
      const Eigen::Vector2f at = start + outwards * float(step);
      const int u = int(std::lround(at.x())), v = int(std::lround(at.y()));
      if (u < 0 || v < 0 || u >= frame_.width() || v >= frame_.height())
        return step <= 3 ? Beyond::image_edge : Beyond::nothing;
      const float z = frame_.depth(v, u);
      if (z <= 0 || surfaces_.labels(v, u) == line.surface + 1) continue;
      const float here = frame_.depth.ptr<float>()[pixel];
      // A surface may lean by 2 in depth for each step across.
      const float footprint = here / float(frame_.camera.fx);
      const float tolerance = 3 * float(frame_.noise.at(here)) + 2 * footprint * float(std::min(step, 4));
      return z < here - tolerance ? Beyond::nearer : z > here + tolerance ? Beyond::farther : Beyond::level;
    }
    return Beyond::nothing;
  }

  const Frame& frame_;
  const SurfaceSet& surfaces_;
  const Scale scale_;
};

bool longer(const BoundaryLine& x, const BoundaryLine& y) {
  const auto key = [](const BoundaryLine& l) {
    return std::tuple(-l.length, l.ends[0].x(), l.ends[0].y(), l.ends[1].x(), l.ends[1].y());
  };
  return key(x) < key(y);
}

void keep_longest(std::vector<BoundaryLine>& lines) {
  std::sort(lines.begin(), lines.end(), longer);
  if (lines.size() > most_lines) lines.resize(most_lines);
}

}  // namespace

BoundaryLines find_boundary_lines(const Frame& frame, const SurfaceSet& surfaces,
                                  const std::vector<std::vector<Contour>>& contours) {
  const LineMaker maker(frame, surfaces);
  std::vector<std::vector<BoundaryLine>> found(contours.size());
  tbb::parallel_for(std::size_t{0}, contours.size(), [&](std::size_t s) {
    for (const Contour& contour : contours[s]) maker.append(int(s), contour, found[s]);
  });
  BoundaryLines result;
  for (const std::vector<BoundaryLine>& lines : found)
    result.lines.insert(result.lines.end(), lines.begin(), lines.end());
  keep_longest(result.lines);
  split_where_met(frame, result);
  keep_longest(result.lines);
  link_lines(frame, result);
  return result;
}

}  // namespace gestalt
