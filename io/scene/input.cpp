// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/input.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "camera_fit.h"
#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/scene_path.h"
#include "npz_scene.h"
#include "png_file.h"
#include "point_cloud.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

std::string text(cv::Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

cv::Size size_of(const Camera& camera) { return {camera.width, camera.height}; }

std::string camera_name(const CameraFile& camera) {
  return camera.file.empty() ? "the given camera" : camera.file.string();
}

void check_size(const CameraFile& camera, cv::Size size, const fs::path& image) {
  if (size_of(camera.camera) != size)
    throw InputError(camera_name(camera) + ": is made for " + text(size_of(camera.camera)) + " images, " +
                     image.string() + " is " + text(size) + "; give the camera file of this sensor mode");
}

std::optional<CameraFile> choose_camera(const fs::path& scene, const std::optional<CameraFile>& given) {
  if (given) return given;
  const auto file = find_camera_file(scene);
  return file ? std::optional(read_camera(*file)) : std::nullopt;
}

/// Reads an image that lies beside depth.png and must have its size.
template <class Image>
Image read_companion(const fs::path& file, Image (*read)(const fs::path&), cv::Size size) {
  Image image = read(file);
  if (image.size() != size)
    throw InputError(file.string() + ": is " + text(image.size()) + ", depth.png is " + text(size) +
                     "; register the images to one size");
  return image;
}

Input read_folder(const fs::path& folder, const std::optional<CameraFile>& given) {
  std::error_code error;
  const fs::path depth_file = folder / "depth.png", colour_file = folder / "rgb.png", label_file = folder / "label.png";
  if (!fs::exists(depth_file, error))
    throw InputError(depth_file.string() +
                     ": does not exist; a scene folder needs the depth image as 16-bit PNG under this name");
  const cv::Mat_<std::uint16_t> raw = read_depth_png(depth_file);
  const auto camera = choose_camera(folder, given);
  if (!camera)
    throw InputError(folder.string() + ": has no camera.yaml, nor has a parent folder; write one or give --camera");
  check_size(*camera, raw.size(), depth_file);
  if (cv::countNonZero(raw) == 0)
    throw InputError(depth_file.string() + ": no pixel has a measurement (all are 0); record the scene again");

  Input input;
  cv::Mat colour;
  if (fs::exists(colour_file, error)) colour = read_companion(colour_file, read_colour_png, raw.size());
  if (fs::exists(label_file, error)) input.ground_truth = read_companion(label_file, read_label_png, raw.size());
  input.frame = make_frame(folder.string(), colour, depth_in_metres(raw, camera->depth_scale), camera->camera);
  return input;
}

/// Images of a cloud's points, as they are filled.
struct CloudImages {
  CloudImages(const PointCloud& cloud, cv::Size size) : depth(size, 0.0f) {
    if (!cloud.colours.empty()) colour = cv::Mat_<cv::Vec3b>(size, cv::Vec3b());
    if (!cloud.labels.empty()) label = cv::Mat_<std::uint16_t>(size, std::uint16_t{0});
  }

  void put(const PointCloud& cloud, std::size_t point, int pixel) {
    if (cloud.visible(point)) depth.ptr<float>()[pixel] = cloud.points[point][2];
    if (!colour.empty()) colour.ptr<cv::Vec3b>()[pixel] = cloud.colours[point];
    if (!label.empty()) label.ptr<std::uint16_t>()[pixel] = cloud.labels[point];
  }

  cv::Mat_<float> depth;
  cv::Mat_<cv::Vec3b> colour;
  cv::Mat_<std::uint16_t> label;
};

/// A camera.yaml of a parent folder may be another sensor's: the points tell. One that is given is taken at its word.
void check_fit(const CameraFile& found, const fs::path& file, const PointCloud& cloud) {
  const double error = median_reprojection_error(cloud, found.camera);
  if (error > largest_reprojection_error)
    throw InputError(found.file.string() + ": does not describe " + file.string() + ", whose points it sees " +
                     std::to_string(int(error + 0.5)) +
                     " px (median) from where they are stored; put the right camera.yaml beside the cloud or give "
                     "--camera");
}

Input read_organized(const fs::path& file, const PointCloud& cloud, const Camera& camera) {
  CloudImages images(cloud, {cloud.width, cloud.height});
  for (std::size_t i = 0; i < cloud.points.size(); ++i) images.put(cloud, i, int(i));
  Input input;
  input.ground_truth = images.label;
  input.frame = make_frame(file.string(), images.colour, images.depth, camera);
  return input;
}

/// Row-major index of the pixel that a point is seen in, -1 when it is not seen.
int pixel_of(const cv::Vec3f& p, const Camera& camera) {
  const double u = std::floor(camera.fx * p[0] / p[2] + camera.cx + 0.5);
  const double v = std::floor(camera.fy * p[1] / p[2] + camera.cy + 0.5);
  if (!(u >= 0 && u < camera.width && v >= 0 && v < camera.height)) return -1;
  return int(v) * camera.width + int(u);
}

Input read_unorganized(const fs::path& file, const PointCloud& cloud, const std::optional<CameraFile>& given) {
  if (!given)
    throw InputError(file.string() +
                     ": is an unorganized cloud (HEIGHT 1), whose points cannot be put into an image without the "
                     "camera; give --camera, or camera.yaml beside the cloud or in a parent folder");
  const Camera& camera = given->camera;
  if (camera.width < 1 || camera.height < 1)
    throw InputError(camera_name(*given) + ": width and height must be positive");
  Input input;
  input.cloud = cloud.points;
  input.point_pixels.assign(cloud.points.size(), -1);
  std::vector<std::size_t> order;  // of the seen points, nearest last: it wins its pixel
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (!cloud.visible(i)) continue;
    input.point_pixels[i] = pixel_of(cloud.points[i], camera);
    if (input.point_pixels[i] >= 0) order.push_back(i);
  }
  if (order.empty())
    throw InputError(file.string() + ": no point lies in the image of " + camera_name(*given) +
                     "; give the camera that took the cloud, with x right, y down, z forward in metres");
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return cloud.points[a][2] > cloud.points[b][2]; });
  CloudImages images(cloud, size_of(camera));
  for (const std::size_t i : order) images.put(cloud, i, input.point_pixels[i]);
  input.ground_truth = images.label;
  input.frame = make_frame(file.string(), images.colour, images.depth, camera);
  return input;
}

Input read_cloud(const fs::path& file, const std::optional<CameraFile>& given) {
  const PointCloud cloud = read_point_cloud(file);
  const cv::Size size(cloud.width, cloud.height);
  const auto camera = choose_camera(file, given);
  if (cloud.height == 1 && !(camera && size_of(camera->camera) == size)) return read_unorganized(file, cloud, camera);
  if (!camera) return read_organized(file, cloud, fit_camera(file, cloud));
  check_size(*camera, size, file);
  if (!given) check_fit(*camera, file, cloud);
  return read_organized(file, cloud, camera->camera);
}

}  // namespace

cv::Mat_<float> depth_in_metres(const cv::Mat_<std::uint16_t>& raw, double scale) {
  cv::Mat_<float> depth(raw.size());
  const auto* first = raw.ptr<std::uint16_t>();
  // In double, so that a whole number of millimetres becomes the nearest float.
  std::transform(first, first + raw.total(), depth.ptr<float>(), [&](std::uint16_t d) { return float(d * scale); });
  return depth;
}

Input read_scene(const fs::path& path, const std::optional<CameraFile>& camera) {
  std::error_code error;
  Input input = fs::is_directory(path, error)     ? read_folder(path, camera)
                : lower_extension(path) == ".npz" ? read_npz_scene(path, camera)
                                                  : read_cloud(path, camera);
  input.path = path;
  input.frame.name = scene_name(path);  // messages until here name the path
  return input;
}

}  // namespace gestalt
