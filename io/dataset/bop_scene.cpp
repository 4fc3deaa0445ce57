// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/dataset/bop_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/json_file.h"
#include "gestalt/core/pipeline/learning_set.h"
#include "gestalt/io/scene/natural_order.h"
#include "gestalt/io/scene/png_file.h"
#include "image_set.h"

namespace gestalt {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr const char* cameras_file = "scene_camera.json";
constexpr std::uintmax_t largest_cameras = std::uintmax_t{1} << 28;  // bytes
constexpr int most_masks = 6552;

json read_cameras(const fs::path& scene) {
  const fs::path file = scene / cameras_file;
  json cameras = read_json(file, largest_cameras);
  if (!cameras.is_object() || cameras.empty())
    throw InputError(file.string() + ": is no map of image numbers to cameras, in JSON; take the file of the data set");
  return cameras;
}

/// "000012" of 12.
std::string six_digits(int number) {
  const std::string digits = std::to_string(number);
  return std::string(digits.size() < 6 ? 6 - digits.size() : 0, '0') + digits;
}

/// The camera of an image, its size from the depth image; depth_scale in metres.
CameraFile camera_of(const fs::path& file, const json& entry, const std::string& key, cv::Size size) {
  const auto fail = [&](const std::string& what) { throw InputError(file.string() + ": " + key + ": " + what); };
  const json k = entry.is_object() ? entry.value("cam_K", json()) : json();
  const auto is_number = [](const json& value) { return value.is_number(); };
  if (!k.is_array() || k.size() != 9 || !std::all_of(k.begin(), k.end(), is_number))
    fail("cam_K must be a list of 9 numbers");
  const auto lies_in = [](const json& value, double low, double high) {
    return value.get<double>() >= low && value.get<double>() <= high;
  };
  if (!lies_in(k[0], 0.01, 1e7) || !lies_in(k[4], 0.01, 1e7) || !lies_in(k[2], 0, size.width) ||
      !lies_in(k[5], 0, size.height))
    fail("cam_K must have focal lengths from 0.01 to 1e7 pixels and its principal point in the image");
  const json scale = entry.value("depth_scale", json(1.0));  // millimetres a unit
  if (!scale.is_number() || !(scale.get<double>() >= 1e-3 && scale.get<double>() <= 1000))
    fail("depth_scale must be a number from 0.001 to 1000, millimetres for each unit of the depth image");
  CameraFile camera(Camera{size.width, size.height, k[0], k[4], k[2], k[5]});
  camera.depth_scale = scale.get<double>() / 1000;
  return camera;
}

/// The number of the object that each pixel shows, by mask_visib/<image>_<object>.png; nothing where there is no mask.
std::optional<cv::Mat_<std::uint16_t>> read_masks(const fs::path& folder, const std::string& image, cv::Size size) {
  std::error_code error;
  cv::Mat_<std::uint16_t> objects(size, std::uint16_t{0});
  int number = 0;
  for (; number < most_masks; ++number) {
    const fs::path file = folder / (image + "_" + six_digits(number) + ".png");
    if (!fs::exists(file, error)) break;
    objects.setTo(number + 1, read_labels(file, size) != 0);
  }
  return number ? std::optional(objects) : std::nullopt;
}

}  // namespace

std::vector<BopImage> find_bop_images(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> scenes;
  if (fs::exists(folder / cameras_file, error)) {
    scenes.push_back(folder);
  } else {
    fs::directory_iterator entry(folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
      std::error_code ignored;
      if (fs::exists(entry->path() / cameras_file, ignored)) scenes.push_back(entry->path());
    }
    if (error) throw InputError(folder.string() + ": cannot be listed: " + error.message());
  }
  if (scenes.empty())
    throw InputError(folder.string() +
                     ": neither it nor a folder in it has scene_camera.json; give a BOP scene, or a "
                     "folder of them as 'test'");
  std::sort(scenes.begin(), scenes.end(),
            [](const fs::path& a, const fs::path& b) { return natural_less(a.string(), b.string()); });
  std::vector<BopImage> images;
  for (const fs::path& scene : scenes) {
    std::vector<int> numbers;
    const json cameras = read_cameras(scene);
    for (const auto& [key, camera] : cameras.items()) {
      if (key.empty() || key.size() > 6 || key.find_first_not_of("0123456789") != key.npos)
        throw InputError((scene / cameras_file).string() + ": '" + key.substr(0, 40) + "' is no number of an image");
      numbers.push_back(std::stoi(key));
    }
    std::sort(numbers.begin(), numbers.end());
    for (const int number : numbers) images.push_back({scene, number, scene / "depth" / (six_digits(number) + ".png")});
  }
  return images;
}

std::string bop_name(const BopImage& image) { return scene_name(image.scene) + "_" + six_digits(image.number); }

ConvertedScene read_bop_image(const BopImage& image, const ReadOptions& options) {
  const std::string name = six_digits(image.number);
  const fs::path file = image.scene / cameras_file;
  const cv::Size size = read_depth_png(image.depth).size();
  const std::string key = std::to_string(image.number);
  const json cameras = read_cameras(image.scene);
  const CameraFile own = camera_of(file, cameras.contains(key) ? cameras[key] : cameras.value(name, json()), key, size);
  ConvertedScene scene;
  scene.camera = options.camera ? options.camera->camera : own.camera;
  scene.depth_scale = scale_of(options, own.depth_scale.value());
  std::error_code error;
  fs::path colour;
  for (const char* folder : {"rgb", "gray"})
    if (colour.empty() && fs::exists(image.scene / folder / (name + ".png"), error))
      colour = image.scene / folder / (name + ".png");
  if (colour.empty())
    throw InputError((image.scene / "rgb" / (name + ".png")).string() +
                     ": does not exist, nor is there one in gray/; images must be PNG");
  scene.images = read_images(image.depth, colour, scene.camera);
  question(scene, image.depth, options);
  const fs::path masks = image.scene / "mask_visib";
  if (const auto objects = read_masks(masks, name, size)) {
    scene.images.label = labels_from(masks, *objects, scene.images.depth);
    scene.objects = count_objects(scene.images.label);
  }
  return scene;
}

}  // namespace gestalt
