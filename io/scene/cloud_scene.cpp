// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cloud_scene.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "camera_fit.h"
#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/depth_reading.h"
#include "gestalt/io/scene/ground_truth.h"
#include "gestalt/io/scene/labelled_files.h"
#include "gestalt/io/scene/pcd_header.h"
#include "point_cloud.h"
#include "scene_camera.h"

namespace gestalt {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

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
                     std::to_string(std::lround(error)) +
                     " px (median) from where they are stored; put the right camera.yaml beside the cloud or give "
                     "--camera");
}

Input read_organized(const fs::path& file, const PointCloud& cloud, const Camera& camera, const DepthUnit& unit,
                     LabelScheme labels) {
  CloudImages images(cloud, {cloud.width, cloud.height});
  for (std::size_t i = 0; i < cloud.points.size(); ++i) images.put(cloud, i, int(i));
  Input input;
  set_frame(input, file.string(), images.colour, {images.depth, unit, false, DepthKind::plain}, camera);
  set_ground_truth(input, images.label, input.frame.depth > 0, labels, file.string() + ": field label");
  return input;
}

/// Row-major index of the pixel that a point is seen in, -1 when it is not seen.
int pixel_of(const cv::Vec3f& p, const Camera& camera) {
  const double u = std::floor(camera.fx * p[0] / p[2] + camera.cx + 0.5);
  const double v = std::floor(camera.fy * p[1] / p[2] + camera.cy + 0.5);
  if (!(u >= 0 && u < camera.width && v >= 0 && v < camera.height)) return -1;
  return int(v) * camera.width + int(u);
}

Input read_unorganized(const fs::path& file, const PointCloud& cloud, const std::optional<CameraFile>& given,
                       const DepthUnit& unit, LabelScheme labels) {
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
  set_frame(input, file.string(), images.colour, {images.depth, unit, false, DepthKind::plain}, camera);
  set_ground_truth(input, images.label, input.frame.depth > 0, labels, file.string() + ": field label");
  return input;
}

Input read_cloud(const fs::path& file, PointCloud cloud, const ReadOptions& options) {
  if (options.depth_kind != DepthKind::plain)
    throw InputError(file.string() + ": is a cloud, whose points have x, y and z; leave out --depth-kind");
  const DepthUnit unit = unit_of_floats(options);
  if (unit.metres != 1)
    for (cv::Vec3f& point : cloud.points) point = cv::Vec3f(cv::Vec3d(point) * unit.metres);
  const cv::Size size(cloud.width, cloud.height);
  const auto camera = choose_camera(file, options.camera);
  if (cloud.height == 1 && !(camera && size_of(camera->camera) == size))
    return read_unorganized(file, cloud, camera, unit, options.labels);
  if (!camera) return read_organized(file, cloud, fit_camera(file, cloud), unit, options.labels);
  check_size(*camera, size, file);
  if (!options.camera) check_fit(*camera, file, cloud);
  return read_organized(file, cloud, camera->camera, unit, options.labels);
}

Frame frame_of(const ConvertedScene& scene) {
  return make_frame("", scene.images.colour, depth_in_metres(scene.images.depth, scene.depth_scale), scene.camera);
}

}  // namespace

Input read_pcd_scene(const fs::path& file, const ReadOptions& options) {
  return read_cloud(file, read_pcd(file), options);
}

Input read_ply_scene(const fs::path& file, const ReadOptions& options) {
  return read_cloud(file, read_ply(file), options);
}

Json pcd_facts(const fs::path& file, const ReadOptions& options) {
  const PcdHeader header = read_pcd_header(file);
  Json fields = Json::array();
  for (const PcdHeader::Field& field : header.fields)
    fields.push_back(field.name + ":" + field.type + std::to_string(field.size) +
                     (field.count > 1 ? "x" + std::to_string(field.count) : ""));
  Json facts{{"kind", header.height > 1 ? "organized cloud" : "unorganized cloud"},
             {"points", header.points()},
             {"fields", fields},
             {"data", to_string(header.data)}};
  if (header.height == 1 && !options.camera && !find_camera_file(file))
    facts["camera_from"] = "none; give --camera, or camera.yaml beside the cloud or in a parent folder";
  return facts;
}

std::string encode_pcd_scene(const ConvertedScene& scene) { return encode_pcd(frame_of(scene), scene.images.label); }

std::string encode_ply_scene(const ConvertedScene& scene) { return encode_ply(frame_of(scene), scene.images.label); }

}  // namespace gestalt
