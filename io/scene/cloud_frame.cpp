// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cloud_frame.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "camera_fit.h"
#include "projection_solution.h"

namespace gestalt {

namespace {

constexpr std::size_t sample_size = 4000;
constexpr std::size_t fewest_points = 16;  // that can tell a frame
constexpr double nearly_all = 0.95;

bool is_finite(const cv::Vec3f& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

/// Points that a sensor measured: programs write those without a measurement as NaN or as the origin.
bool is_measured(const cv::Vec3f& p) { return is_finite(p) && p != cv::Vec3f(); }

/// Evenly taken points, each with the pixel it is stored in, as an organized cloud has them.
std::vector<StoredPoint> sample_of(const PointCloud& cloud) {
  std::vector<std::size_t> measured;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (is_measured(cloud.points[i])) measured.push_back(i);
  std::vector<StoredPoint> sample;
  const std::size_t taken = std::min(sample_size, measured.size());
  for (std::size_t k = 0; k < taken; ++k) {
    const std::size_t i = measured[k * measured.size() / taken];
    const std::size_t width = std::size_t(cloud.width);
    sample.push_back({cloud.points[i], {double(i % width), double(i / width)}});
  }
  return sample;
}

cv::Vec3d moved(const FrameChange& change, const cv::Vec3f& p) {
  return change.rotation * cv::Vec3d(p) + change.translation;
}

std::vector<StoredPoint> moved(const FrameChange& change, std::vector<StoredPoint> sample) {
  for (StoredPoint& stored : sample) stored.point = cv::Vec3f(moved(change, stored.point));
  return sample;
}

FrameChange of_axes(const cv::Matx33d& rotation, const std::string& name) { return {rotation, {}, name}; }

const FrameChange opengl = of_axes({1, 0, 0, 0, -1, 0, 0, 0, -1}, "OpenGL's frame (y up, z backwards)");
const FrameChange robot_link = of_axes({0, -1, 0, 0, 0, -1, 1, 0, 0}, "a robot's frame (x forward, y left, z up)");

/// "x right" and so on, by what the rotation makes of the axes.
std::string axes_of(const cv::Matx33d& rotation) {
  static const std::array<std::array<const char*, 2>, 3> names{
      {{"right", "left"}, {"down", "up"}, {"forward", "backwards"}}};
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
    for (int row = 0; row < 3; ++row)
      if (rotation(row, axis) != 0)
        text += (text.empty() ? "" : ", ") + std::string(1, "xyz"[axis]) + " " +
                names[std::size_t(row)][rotation(row, axis) > 0 ? 0 : 1];
  return text;
}

/// All turns and reflections that take axes to axes, the frames that programs use first; not the identity.
std::vector<FrameChange> permutations() {
  std::vector<FrameChange> all{opengl, robot_link};
  std::array<int, 3> order{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      cv::Matx33d rotation = cv::Matx33d::zeros();
      for (int row = 0; row < 3; ++row) rotation(row, order[std::size_t(row)]) = signs >> row & 1 ? -1 : 1;
      const bool known =
          rotation == cv::Matx33d::eye() || rotation == opengl.rotation || rotation == robot_link.rotation;
      if (known) continue;
      const bool mirrored = cv::determinant(rotation) < 0;
      all.push_back(of_axes(rotation, std::string(mirrored ? "a mirrored frame (" : "a frame with ") +
                                          axes_of(rotation) + (mirrored ? ")" : "")));
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return all;
}

/// From the world to the sensor, as VIEWPOINT tells its pose; nothing for the identity, or what is not a rotation.
std::optional<FrameChange> of_viewpoint(const PointCloud& cloud) {
  const auto& v = cloud.viewpoint;
  const double norm = std::sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5] + v[6] * v[6]);
  if (!(std::abs(norm - 1) < 0.01)) return std::nullopt;
  const double w = v[3] / norm, x = v[4] / norm, y = v[5] / norm, z = v[6] / norm;
  const cv::Matx33d pose(1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),  //
                         2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),  //
                         2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y));
  const cv::Vec3d position(v[0], v[1], v[2]);
  if (cv::norm(pose - cv::Matx33d::eye()) < 1e-9 && cv::norm(position) < 1e-9) return std::nullopt;
  return FrameChange{pose.t(), -(pose.t() * position), "the frame that VIEWPOINT is given in"};
}

FrameChange then(const FrameChange& first, const FrameChange& second) {
  return {second.rotation * first.rotation, second.rotation * first.translation + second.translation, first.name};
}

/// What VIEWPOINT tells, with the sensor's axes as cameras, robots and OpenGL have them.
std::vector<FrameChange> viewpoint_frames(const PointCloud& cloud) {
  const auto viewpoint = of_viewpoint(cloud);
  if (!viewpoint) return {};
  return {*viewpoint, then(*viewpoint, robot_link), then(*viewpoint, opengl)};
}

bool fits(const std::vector<StoredPoint>& sample, cv::Size size, const std::optional<Camera>& camera) {
  const auto before =
      std::count_if(sample.begin(), sample.end(), [](const auto& stored) { return stored.point[2] > 0; });
  if (double(before) < nearly_all * double(sample.size())) return false;
  const std::optional<Camera> own = camera ? camera : fitted_camera(sample, size);
  return own && looks_forward(*own) && median_reprojection_error(sample, *own) <= largest_reprojection_error;
}

/// Of points in the camera's frame; the middle of x / z and y / z of all but the outermost hundredth.
bool has_field_of_view(const PointCloud& cloud, const FrameChange& change) {
  constexpr double widest = 1.5;  // of the tangent to either side: 113 degrees
  std::vector<double> horizontal, vertical;
  std::size_t points = 0;
  for (const cv::Vec3f& p : cloud.points) {
    if (!is_measured(p)) continue;
    ++points;
    const cv::Vec3d q = moved(change, p);
    if (!(q[2] > 0)) continue;
    horizontal.push_back(q[0] / q[2]), vertical.push_back(q[1] / q[2]);
  }
  if (points == 0 || double(horizontal.size()) < 0.999 * double(points)) return false;
  const auto is_narrow = [&](std::vector<double>& tangents) {
    const auto quantile = [&](double share) {
      const auto at = tangents.begin() + std::ptrdiff_t(share * double(tangents.size() - 1));
      std::nth_element(tangents.begin(), at, tangents.end());
      return *at;
    };
    return quantile(0.01) > -widest && quantile(0.99) < widest;
  };
  return is_narrow(horizontal) && is_narrow(vertical);
}

}  // namespace

PointCloud FrameChange::operator()(PointCloud cloud) const {
  for (cv::Vec3f& p : cloud.points)
    if (is_measured(p)) p = cv::Vec3f(moved(*this, p));
  return cloud;
}

std::optional<FrameChange> frame_of_organized(const PointCloud& cloud, const std::optional<Camera>& camera) {
  const std::vector<StoredPoint> sample = sample_of(cloud);
  const cv::Size size(cloud.width, cloud.height);
  if (sample.size() < fewest_points) return std::nullopt;
  std::vector<FrameChange> frames = viewpoint_frames(cloud);
  const std::vector<FrameChange> turned = permutations();
  frames.insert(frames.end(), turned.begin(), turned.end());
  for (const FrameChange& frame : frames)
    if (fits(moved(frame, sample), size, camera)) return frame;
  if (const auto solved = solve_projection(sample)) {
    const FrameChange frame{solved->rotation, solved->translation, "a frame that is not the camera's"};
    if (fits(moved(frame, sample), size, camera)) return frame;
  }
  return std::nullopt;
}

bool mostly_visible(const PointCloud& cloud) {
  std::size_t measured = 0, visible = 0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    measured += is_measured(cloud.points[i]);
    visible += cloud.visible(i);
  }
  return 2 * visible >= measured;
}

double share_in_image(const PointCloud& cloud, const Camera& camera) {
  std::size_t points = 0, inside = 0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (!is_measured(cloud.points[i])) continue;
    ++points;
    if (cloud.visible(i) && pixel_of(cloud.points[i], camera) >= 0) ++inside;
  }
  return points == 0 ? 0 : double(inside) / double(points);
}

namespace {

/// Whether the points reach over a good part of the image: what is turned wrongly and far away is a spot.
bool fills_image(const PointCloud& cloud, const Camera& camera) {
  constexpr int share = 4;
  int left = camera.width, right = -1, top = camera.height, bottom = -1;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const int pixel = cloud.visible(i) ? pixel_of(cloud.points[i], camera) : -1;
    if (pixel < 0) continue;
    left = std::min(left, pixel % camera.width), right = std::max(right, pixel % camera.width);
    top = std::min(top, pixel / camera.width), bottom = std::max(bottom, pixel / camera.width);
  }
  return share * (right - left) > camera.width || share * (bottom - top) > camera.height;
}

}  // namespace

std::optional<FrameChange> frame_of_unorganized(const PointCloud& cloud, const Camera& camera) {
  std::vector<FrameChange> frames = viewpoint_frames(cloud);
  frames.push_back(opengl);
  frames.push_back(robot_link);
  std::optional<FrameChange> best;
  double most = nearly_all;
  for (const FrameChange& frame : frames) {
    const PointCloud turned = frame(cloud);
    const double share = share_in_image(turned, camera);
    if (share > most && fills_image(turned, camera)) best = frame, most = share;
  }
  return best;
}

std::optional<FrameChange> frame_of_unorganized(const PointCloud& cloud) {
  std::vector<FrameChange> frames{FrameChange()};
  const std::vector<FrameChange> viewpoint = viewpoint_frames(cloud);
  frames.insert(frames.end(), viewpoint.begin(), viewpoint.end());
  frames.push_back(opengl);
  frames.push_back(robot_link);
  for (const FrameChange& frame : frames)
    if (has_field_of_view(cloud, frame)) return frame;
  return std::nullopt;
}

}  // namespace gestalt
