// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "coloured_regions.h"

#include <cmath>
#include <vector>

namespace {

/// Unit normal towards the camera from four pixels around one; (0, 0, 0) where one of them has no depth.
cv::Vec3f normal(const gestalt::Frame& frame, int v, int u, int radius) {
  const int left = std::max(u - radius, 0), right = std::min(u + radius, frame.width() - 1);
  const int up = std::max(v - radius, 0), down = std::min(v + radius, frame.height() - 1);
  for (const float depth :
       {frame.depth(v, u), frame.depth(v, left), frame.depth(v, right), frame.depth(up, u), frame.depth(down, u)})
    if (depth == 0) return {};
  const cv::Vec3f n =
      (frame.points(down, u) - frame.points(up, u)).cross(frame.points(v, right) - frame.points(v, left));
  const float length = float(cv::norm(n)), towards = n.dot(frame.points(v, u));
  if (length == 0 || towards == 0) return {};
  return n * ((towards > 0 ? -1 : 1) / length);
}

/// Red against green and blue against yellow, which light and shade leave as they are, nearly.
cv::Vec2f chroma(const cv::Vec3b& bgr) {
  const float b = bgr[0], g = bgr[1], r = bgr[2];
  return {(r - g) / std::sqrt(2.0f), (r + g - 2 * b) / std::sqrt(6.0f)};
}

/// What a growing patch has in the mean.
class Mean {
 public:
  void add(const cv::Vec3f& normal, const cv::Vec2f& colour) {
    normals_ += normal, colours_ += colour;
    ++count_;
  }
  float cosine(const cv::Vec3f& normal) const { return normal.dot(normals_) / float(cv::norm(normals_)); }
  float difference(const cv::Vec2f& colour) const { return float(cv::norm(colour - colours_ * (1.0f / count_))); }

 private:
  cv::Vec3f normals_;
  cv::Vec2f colours_;
  float count_ = 0;
};

}  // namespace

const gestalt::Parameters<ColouredRegions::Params>& ColouredRegions::parameters() {
  static const auto parameters =
      gestalt::Parameters<Params>()
          .integer("radius", &Params::radius, 1, 50, "pixels", "a normal is taken from the pixels at this distance")
          .real("angle", &Params::angle, 0.01, 3.2, "rad", "largest angle of a normal to its patch's mean")
          .real("jump", &Params::jump, 1e-4, 1, "", "a greater step of depth, as a share of it, separates patches")
          .real("colour", &Params::colour, 0, 1000, "", "largest difference of colour to its patch's mean, of 8 bits")
          .integer("smallest", &Params::smallest, 1, 1000000, "pixels", "smaller regions are not made patches");
  return parameters;
}

gestalt::PatchMap ColouredRegions::cluster(const gestalt::Frame& frame) const {
  gestalt::PatchMap map{cv::Mat_<int>(frame.depth.size(), 0), cv::Mat_<cv::Vec3f>(frame.depth.size()), 0};
  for (int v = 0; v < frame.height(); ++v)
    for (int u = 0; u < frame.width(); ++u) map.normals(v, u) = normal(frame, v, u, params_.radius);
  const auto colour_at = [&](cv::Point at) {
    return frame.has_colour() ? chroma(frame.colour.at<cv::Vec3b>(at)) : cv::Vec2f();
  };
  const float smallest_cosine = float(std::cos(params_.angle));
  constexpr int open_pixel = 0, no_patch = -1;

  for (int v = 0; v < frame.height(); ++v)
    for (int u = 0; u < frame.width(); ++u) {
      if (map.labels(v, u) != open_pixel || map.normals(v, u) == cv::Vec3f()) continue;
      std::vector<cv::Point> region{{u, v}};
      const int label = map.count + 1;
      map.labels(v, u) = label;
      Mean mean;
      mean.add(map.normals(v, u), colour_at({u, v}));
      for (std::size_t next = 0; next < region.size(); ++next)  // breadth first, so that the mean is of what is near
        for (const cv::Point step : {cv::Point(1, 0), cv::Point(-1, 0), cv::Point(0, 1), cv::Point(0, -1)}) {
          const cv::Point from = region[next], to = from + step;
          if (!cv::Rect({}, map.labels.size()).contains(to) || map.labels(to) != open_pixel) continue;
          const cv::Vec3f there = map.normals(to);
          if (there == cv::Vec3f() || mean.cosine(there) < smallest_cosine ||
              mean.difference(colour_at(to)) > params_.colour ||
              std::abs(frame.depth(to) - frame.depth(from)) > params_.jump * frame.depth(from))
            continue;
          map.labels(to) = label;
          mean.add(there, colour_at(to));
          region.push_back(to);
        }
      if (int(region.size()) < params_.smallest)
        for (const cv::Point pixel : region) map.labels(pixel) = no_patch;
      else
        ++map.count;
    }
  for (int& label : map.labels) label = std::max(label, 0);
  return map;
}
