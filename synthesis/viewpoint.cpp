// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "viewpoint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace gestalt::synthesis {

Preview::Preview(const Viewpoint& viewpoint)
    : camera_(viewpoint.camera),
      // Points 2.5 mm apart must cover the pixels of a surface 0.6 m away.
      scale_(std::min(1.0, 131.0 / std::max(viewpoint.camera.fx, viewpoint.camera.fy))),
      from_world_(viewpoint.pose.inverse().cast<float>()),
      depth_(std::max(1, int(std::lround(camera_.height * scale_))),
             std::max(1, int(std::lround(camera_.width * scale_))), std::numeric_limits<float>::infinity()),
      thing_(depth_.size(), -1) {}

cv::Point Preview::pixel_of(const Eigen::Vector3f& p) const {
  if (p.z() <= 0.1f) return {-1, -1};
  const double u = camera_.fx * p.x() / p.z() + camera_.cx, v = camera_.fy * p.y() / p.z() + camera_.cy;
  return {int(std::floor((u + 0.5) * scale_)), int(std::floor((v + 0.5) * scale_))};
}

double Preview::share_inside(std::span<const Eigen::Vector3f> points) const {
  const cv::Rect image({0, 0}, depth_.size());
  const auto inside = std::count_if(points.begin(), points.end(), [&](const Eigen::Vector3f& point) {
    return image.contains(pixel_of(from_world_ * point));
  });
  return points.empty() ? 0.0 : double(inside) / double(points.size());
}

bool Preview::add(std::span<const Eigen::Vector3f> points, double smallest) {
  const cv::Mat_<float> depth = depth_.clone();
  const cv::Mat_<int> thing = thing_.clone();
  draw(points, things_);
  std::vector<int> visible(std::size_t(things_ + 1), 0);
  for (const int seen : thing_)
    if (seen >= 0) ++visible[std::size_t(seen)];
  if (*std::min_element(visible.begin(), visible.end()) < smallest * scale_ * scale_) {
    depth_ = depth;
    thing_ = thing;
    return false;
  }
  ++things_;
  return true;
}

void Preview::hide_behind(std::span<const Eigen::Vector3f> points) { draw(points, -1); }

void Preview::draw(std::span<const Eigen::Vector3f> points, int thing) {
  const cv::Rect image({0, 0}, depth_.size());
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3f p = from_world_ * point;
    const cv::Point pixel = pixel_of(p);
    if (!image.contains(pixel) || p.z() >= depth_(pixel)) continue;
    depth_(pixel) = p.z();
    thing_(pixel) = thing;
  }
}

std::vector<double> Preview::visible_parts(int thing) const {
  const cv::Mat mask = thing_ == thing;
  cv::Mat labels, statistics, centroids;
  const int count = cv::connectedComponentsWithStats(mask, labels, statistics, centroids, 8);
  std::vector<double> sizes;
  for (int i = 1; i < count; ++i) sizes.push_back(statistics.at<int>(i, cv::CC_STAT_AREA) / (scale_ * scale_));
  std::sort(sizes.rbegin(), sizes.rend());
  return sizes;
}

}  // namespace gestalt::synthesis
