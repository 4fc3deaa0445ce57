// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "camera_fit.h"

#include <algorithm>
#include <cmath>

namespace gestalt {

namespace {

/// Least squares line through points that are added one by one.
class Line {
 public:
  void add(double x, double y) {
    // Moments about the running mean, as sums of squares would cancel.
    ++n_;
    const double dx = x - mean_x_;
    mean_x_ += dx / n_;
    mean_y_ += (y - mean_y_) / n_;
    xx_ += dx * (x - mean_x_);
    xy_ += dx * (y - mean_y_);
  }

  /// Nothing when all x are equal.
  struct Coefficients {
    double slope;
    double offset;
  };
  std::optional<Coefficients> coefficients() const {
    if (!(xx_ > 1e-12 * n_)) return std::nullopt;
    return Coefficients{xy_ / xx_, mean_y_ - xy_ / xx_ * mean_x_};
  }

 private:
  double n_ = 0, mean_x_ = 0, mean_y_ = 0, xx_ = 0, xy_ = 0;
};

/// Calls with each visible point and its pixel.
template <class Use>
void for_each_visible(const PointCloud& cloud, const Use& use) {
  const std::size_t width = std::size_t(cloud.width);
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (cloud.visible(i)) use(cloud.points[i], double(i % width), double(i / width));
}

template <class Use>
void for_each_visible(const std::vector<StoredPoint>& points, const Use& use) {
  for (const StoredPoint& stored : points)
    if (stored.point[2] > 0) use(stored.point, stored.pixel.x, stored.pixel.y);
}

template <class Points>
std::optional<Camera> fit(const Points& points, cv::Size size) {
  Line columns, rows;
  for_each_visible(points, [&](const cv::Vec3f& p, double u, double v) {
    columns.add(double(p[0]) / p[2], u);
    rows.add(double(p[1]) / p[2], v);
  });
  const auto horizontal = columns.coefficients(), vertical = rows.coefficients();
  if (!horizontal || !vertical) return std::nullopt;
  return Camera{size.width, size.height, horizontal->slope, vertical->slope, horizontal->offset, vertical->offset};
}

template <class Points>
double median_error(const Points& points, const Camera& camera) {
  std::vector<double> errors;
  for_each_visible(points, [&](const cv::Vec3f& p, double u, double v) {
    const double du = camera.fx * p[0] / p[2] + camera.cx - u, dv = camera.fy * p[1] / p[2] + camera.cy - v;
    errors.push_back(std::sqrt(du * du + dv * dv));
  });
  if (errors.empty()) return 0;
  const auto middle = errors.begin() + std::ptrdiff_t(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return *middle;
}

}  // namespace

std::optional<Camera> fitted_camera(const PointCloud& cloud) { return fit(cloud, {cloud.width, cloud.height}); }

std::optional<Camera> fitted_camera(const std::vector<StoredPoint>& points, cv::Size size) { return fit(points, size); }

bool looks_forward(const Camera& camera) {
  return camera.fx > 0 && camera.fy > 0 && camera.cx >= 0 && camera.cx <= camera.width && camera.cy >= 0 &&
         camera.cy <= camera.height;
}

double median_reprojection_error(const PointCloud& cloud, const Camera& camera) { return median_error(cloud, camera); }

double median_reprojection_error(const std::vector<StoredPoint>& points, const Camera& camera) {
  return median_error(points, camera);
}

int pixel_of(const cv::Vec3f& p, const Camera& camera) {
  const double u = std::floor(camera.fx * p[0] / p[2] + camera.cx + 0.5);
  const double v = std::floor(camera.fy * p[1] / p[2] + camera.cy + 0.5);
  if (!(u >= 0 && u < camera.width && v >= 0 && v < camera.height)) return -1;
  return int(v) * camera.width + int(u);
}

}  // namespace gestalt
