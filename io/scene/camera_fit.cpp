// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "camera_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "gestalt/core/base/error.h"

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

}  // namespace

double median_reprojection_error(const PointCloud& cloud, const Camera& camera) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (!cloud.visible(i)) continue;
    const cv::Vec3f& p = cloud.points[i];
    const double u = camera.fx * p[0] / p[2] + camera.cx, v = camera.fy * p[1] / p[2] + camera.cy;
    const double du = u - double(i % std::size_t(cloud.width)), dv = v - double(i / std::size_t(cloud.width));
    errors.push_back(std::sqrt(du * du + dv * dv));
  }
  if (errors.empty()) return 0;
  const auto middle = errors.begin() + std::ptrdiff_t(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return *middle;
}

Camera fit_camera(const std::filesystem::path& file, const PointCloud& cloud) {
  const std::string remedy = "; give --camera, or camera.yaml beside the cloud or in a parent folder";
  Line columns, rows;
  bool any = false;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (!cloud.visible(i)) continue;
    const cv::Vec3f& p = cloud.points[i];
    columns.add(double(p[0]) / p[2], double(i % std::size_t(cloud.width)));
    rows.add(double(p[1]) / p[2], double(i / std::size_t(cloud.width)));
    any = true;
  }
  if (!any)
    throw InputError(file.string() +
                     ": no point of the cloud has finite coordinates and lies before the camera (z > 0)");
  const auto horizontal = columns.coefficients(), vertical = rows.coefficients();
  if (!horizontal || !vertical)
    throw InputError(file.string() + ": the points are too few or too alike to tell the camera's intrinsics" + remedy);
  const Camera camera{cloud.width,     cloud.height,       horizontal->slope,
                      vertical->slope, horizontal->offset, vertical->offset};
  const double error = median_reprojection_error(cloud, camera);
  const bool sees_itself = camera.fx > 0 && camera.fy > 0 && camera.cx >= 0 && camera.cx <= camera.width &&
                           camera.cy >= 0 && camera.cy <= camera.height;
  if (!sees_itself || !(error <= largest_reprojection_error))
    throw InputError(file.string() +
                     ": no pinhole camera describes where the points lie in the grid (in the camera frame x points "
                     "right, y down, z forward)" +
                     remedy);
  return camera;
}

}  // namespace gestalt
