// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cloud_scene.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "camera_fit.h"
#include "cloud_frame.h"
#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/depth_reading.h"
#include "gestalt/io/scene/ground_truth.h"
#include "gestalt/io/scene/labelled_files.h"
#include "gestalt/io/scene/pcd_header.h"
#include "point_cloud.h"
#include "scene_camera.h"
#include "virtual_camera.h"

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

/// A cloud with the camera that sees it, and what was done for that.
struct SeenCloud {
  PointCloud cloud;
  Camera camera;
  Input input{};  ///< with its notes and warnings
};

std::string focal_lengths(const Camera& camera) {
  return std::to_string(std::lround(camera.fx)) + " and " + std::to_string(std::lround(camera.fy)) + " px";
}

/// The camera of an organized cloud that the points, in the camera's frame, are made with; nothing when none is.
std::optional<Camera> own_camera(const PointCloud& cloud) {
  const auto camera = fitted_camera(cloud);
  if (!camera || !looks_forward(*camera) || median_reprojection_error(cloud, *camera) > largest_reprojection_error)
    return std::nullopt;
  return camera;
}

std::string turned(const FrameChange& frame) {
  return "its points are in " + frame.name + "; they are turned into the camera's (x right, y down, z forward)";
}

[[noreturn]] void refuse_camera(const fs::path& file, const PointCloud& cloud, const CameraFile& told,
                                const Camera& camera) {
  const auto own = own_camera(cloud);
  const std::string seen = std::to_string(std::lround(median_reprojection_error(cloud, camera)));
  throw InputError(camera_name(told) + ": does not match " + file.string() + ": it projects the points " + seen +
                   " px (median) away from their places in the grid; " +
                   (own ? "the points imply focal lengths of " + focal_lengths(*own) + ": " : std::string()) +
                   (told.file.filename() == "camera.yaml"
                        ? "put the right camera.yaml beside the cloud or give --camera"
                        : "omit the camera, or give the one that recorded the cloud"));
}

[[noreturn]] void refuse_points(const fs::path& file, const PointCloud& cloud) {
  const std::string remedy =
      "; write the points in the camera's frame (x right, y down, z forward), or as an unorganized cloud (HEIGHT 1)";
  std::size_t visible = 0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) visible += cloud.visible(i);
  if (visible == 0)
    throw InputError(file.string() +
                     ": no point of the cloud has finite coordinates and lies before the camera (z > 0)");
  if (!fitted_camera(cloud))
    throw InputError(file.string() +
                     ": the points are too few or too similar to estimate the camera's intrinsics; give "
                     "--camera, or camera.yaml beside the cloud or in a parent folder");
  throw InputError(
      file.string() +
      ": no pinhole camera projects the points to their places in the grid, in their own frame or any other" + remedy);
}

/// The grid is the image. A given camera, or one in a parent folder, may be another sensor's: the points show it.
SeenCloud see_organized(const fs::path& file, PointCloud cloud, const std::optional<CameraFile>& told) {
  SeenCloud seen;
  std::optional<Camera> camera;
  if (told) camera = camera_for(*told, {cloud.width, cloud.height}, file, seen.input);
  if (camera && median_reprojection_error(cloud, *camera) <= largest_reprojection_error && mostly_visible(cloud)) {
    seen.camera = *camera;
  } else if (const auto own = camera ? std::nullopt : own_camera(cloud)) {
    seen.camera = *own;
  } else if (const auto frame = frame_of_organized(cloud, camera)) {
    seen.input.notes.push_back(turned(*frame));
    cloud = (*frame)(std::move(cloud));
    seen.camera = camera ? *camera : fitted_camera(cloud).value();
  } else if (camera && mostly_visible(cloud)) {
    refuse_camera(file, cloud, *told, *camera);
  } else {
    refuse_points(file, cloud);
  }
  seen.cloud = std::move(cloud);
  return seen;
}

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

/// By a camera that somebody told.
SeenCloud see_unorganized(const fs::path& file, PointCloud cloud, const CameraFile& told) {
  constexpr double fewest = 0.5, doubtful = 0.8;
  const std::string name = camera_name(told);
  if (told.camera.width < 1 || told.camera.height < 1)
    throw InputError(name + ": has no width and height, which an unorganized cloud needs; give --camera with a file " +
                     "that has them: width, height, fx, fy, cx, cy");
  SeenCloud seen;
  for (const std::string& note : told.notes) seen.input.notes.push_back(name + ": " + note);
  double share = share_in_image(cloud, told.camera);
  if (share < fewest)
    if (const auto frame = frame_of_unorganized(cloud, told.camera)) {
      seen.input.notes.push_back(turned(*frame));
      cloud = (*frame)(std::move(cloud));
      share = share_in_image(cloud, told.camera);
    }
  if (share < fewest)
    throw InputError(
        file.string() + ": " + (share == 0 ? "no point lies" : "only " + percent(share) + " of the points lie") +
        " in the image of " + name +
        "; give the camera that recorded the cloud, and write the points in its frame: x right, y down, z forward");
  if (share < doubtful)
    seen.input.warnings.push_back(file.string() + ": " + percent(1 - share) +
                                  " of its points lie outside of the image of " + name);
  seen.camera = filled_camera(cloud, told.camera);
  if (size_of(seen.camera) != size_of(told.camera))
    seen.input.notes.push_back("the " + text(size_of(told.camera)) + " pixels of " + name +
                               " are much finer than the points; the image is " + text(size_of(seen.camera)) +
                               " in place of it");
  seen.cloud = std::move(cloud);
  return seen;
}

/// Without a camera: by one that the points tell.
SeenCloud see_virtually(const fs::path& file, PointCloud cloud) {
  constexpr double mostly = 0.5;
  const std::string what = file.string() + ": is an unorganized cloud (HEIGHT 1) without a camera, ";
  const std::string remedy =
      "; write the points in the camera's frame (x right, y down, z forward), or with the sensor's pose as VIEWPOINT "
      "of a "
      "PCD file, or give --camera (or camera.yaml beside the cloud) if they are in that frame";
  const auto frame = frame_of_unorganized(cloud);
  if (!frame)
    throw InputError(what + "and its points do not lie in the field of view of a camera at their origin" + remedy);
  SeenCloud seen;
  if (frame->rotation != cv::Matx33d::eye()) {
    seen.input.notes.push_back(turned(*frame));
    cloud = (*frame)(std::move(cloud));
  }
  const auto camera = virtual_camera(cloud);
  if (!camera) throw InputError(what + "and its points are too few or too scattered for an image" + remedy);
  if (overlapping_share(cloud, *camera) > mostly)
    throw InputError(what +
                     "and most of its points hide others from its origin: they are in the frame of a robot or a "
                     "world; write them in the camera's frame" +
                     remedy);
  seen.input.notes.push_back(
      "no camera is given for an unorganized cloud; a virtual one of " + text(size_of(*camera)) +
      " pixels with a focal length of " + std::to_string(std::lround(camera->fx)) +
      " px, as dense as the points, sees it from their origin (--camera gives the sensor's own)");
  seen.camera = *camera;
  seen.cloud = std::move(cloud);
  return seen;
}

void finish(Input& input, const fs::path& file, const CloudImages& images, const Camera& camera, const DepthUnit& unit,
            LabelScheme labels) {
  set_frame(input, file.string(), images.colour, {images.depth, unit, false, DepthKind::plain}, camera);
  set_ground_truth(input, images.label, input.frame.depth > 0, labels, file.string() + ": field label");
}

Input read_organized(const fs::path& file, SeenCloud seen, const DepthUnit& unit, LabelScheme labels) {
  const PointCloud& cloud = seen.cloud;
  CloudImages images(cloud, {cloud.width, cloud.height});
  for (std::size_t i = 0; i < cloud.points.size(); ++i) images.put(cloud, i, int(i));
  Input input = std::move(seen.input);
  finish(input, file, images, seen.camera, unit, labels);
  return input;
}

Input read_unorganized(const fs::path& file, std::vector<cv::Vec3f> original, SeenCloud seen, const DepthUnit& unit,
                       LabelScheme labels) {
  const PointCloud& cloud = seen.cloud;
  Input input = std::move(seen.input);
  input.cloud = std::move(original);
  input.point_pixels.assign(cloud.points.size(), -1);
  std::vector<std::size_t> order;  // of the seen points, nearest last: it wins its pixel
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (!cloud.visible(i)) continue;
    input.point_pixels[i] = pixel_of(cloud.points[i], seen.camera);
    if (input.point_pixels[i] >= 0) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return cloud.points[a][2] > cloud.points[b][2]; });
  CloudImages images(cloud, size_of(seen.camera));
  for (const std::size_t i : order) images.put(cloud, i, input.point_pixels[i]);
  finish(input, file, images, seen.camera, unit, labels);
  return input;
}

Input read_cloud(const fs::path& file, PointCloud cloud, const ReadOptions& options) {
  if (options.depth_kind != DepthKind::plain)
    throw InputError(file.string() + ": is a cloud, whose points have x, y and z; leave out --depth-kind");
  const DepthUnit unit = unit_of_floats(options);
  if (unit.metres != 1) {
    for (cv::Vec3f& point : cloud.points) point = cv::Vec3f(cv::Vec3d(point) * unit.metres);
    for (std::size_t axis = 0; axis < 3; ++axis) cloud.viewpoint[axis] *= unit.metres;
  }
  const auto camera = choose_camera(file, options.camera);
  const bool organized = cloud.height > 1 || (camera && size_of(camera->camera) == cv::Size(cloud.width, 1));
  if (organized) return read_organized(file, see_organized(file, std::move(cloud), camera), unit, options.labels);
  std::vector<cv::Vec3f> original = cloud.points;
  SeenCloud seen = camera ? see_unorganized(file, std::move(cloud), *camera) : see_virtually(file, std::move(cloud));
  return read_unorganized(file, std::move(original), std::move(seen), unit, options.labels);
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

Json pcd_facts(const fs::path& file, const ReadOptions&) {
  const PcdHeader header = read_pcd_header(file);
  Json fields = Json::array();
  for (const PcdHeader::Field& field : header.fields)
    fields.push_back(field.name + ":" + field.type + std::to_string(field.size) +
                     (field.count > 1 ? "x" + std::to_string(field.count) : ""));
  Json facts{{"kind", header.height > 1 ? "organized cloud" : "unorganized cloud"},
             {"points", header.points()},
             {"fields", fields},
             {"data", to_string(header.data)}};
  return facts;
}

std::string encode_pcd_scene(const ConvertedScene& scene) { return encode_pcd(frame_of(scene), scene.images.label); }

std::string encode_ply_scene(const ConvertedScene& scene) { return encode_ply(frame_of(scene), scene.images.label); }

}  // namespace gestalt
