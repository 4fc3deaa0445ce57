#include "my_component.h"

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

/// Gives the connected pixels from seed on the label, as far as they have none and may_join(from, to).
template <class MayJoin>
void fill(cv::Mat_<int>& labels, cv::Point seed, int label, const MayJoin& may_join) {
  std::vector<cv::Point> open{seed};
  labels(seed) = label;
  while (!open.empty()) {
    const cv::Point from = open.back();
    open.pop_back();
    for (const cv::Point step : {cv::Point(1, 0), cv::Point(-1, 0), cv::Point(0, 1), cv::Point(0, -1)}) {
      const cv::Point to = from + step;
      if (!cv::Rect({}, labels.size()).contains(to) || labels(to) != 0 || !may_join(from, to)) continue;
      labels(to) = label;
      open.push_back(to);
    }
  }
}

}  // namespace

const gestalt::Parameters<MyComponent::Params>& MyComponent::parameters() {
  static const auto parameters =
      gestalt::Parameters<Params>()
          .integer("radius", &Params::radius, 1, 50, "pixels", "a normal is taken from the pixels at this distance")
          .real("angle", &Params::angle, 0.01, 3.2, "rad", "largest angle of a normal to that of the first pixel")
          .real("jump", &Params::jump, 1e-4, 1, "", "a greater step of depth, as a share of it, separates patches");
  return parameters;
}

gestalt::PatchMap MyComponent::cluster(const gestalt::Frame& frame) const {
  gestalt::PatchMap map{cv::Mat_<int>(frame.depth.size(), 0), cv::Mat_<cv::Vec3f>(frame.depth.size()), 0};
  for (int v = 0; v < frame.height(); ++v)
    for (int u = 0; u < frame.width(); ++u) map.normals(v, u) = normal(frame, v, u, params_.radius);

  const float smallest_cosine = float(std::cos(params_.angle));
  for (int v = 0; v < frame.height(); ++v)
    for (int u = 0; u < frame.width(); ++u) {
      const cv::Vec3f first = map.normals(v, u);
      if (map.labels(v, u) != 0 || first == cv::Vec3f()) continue;
      fill(map.labels, {u, v}, ++map.count, [&](cv::Point from, cv::Point to) {
        return first.dot(map.normals(to)) >= smallest_cosine &&
               std::abs(frame.depth(to) - frame.depth(from)) <= params_.jump * frame.depth(from);
      });
    }
  return map;
}
