// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/dataset/bop_scene.h"

#include <algorithm>

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/bop_cameras.h"
#include "gestalt/io/scene/natural_order.h"
#include "image_set.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

constexpr int most_masks = 6552;

/// The number of the object that each pixel shows, by mask_visib/<image>_<object>.png; nothing where there is no mask.
std::optional<cv::Mat_<std::uint16_t>> read_masks(const fs::path& folder, const std::string& image, cv::Size size) {
  std::error_code error;
  cv::Mat_<std::uint16_t> objects(size, std::uint16_t{0});
  int number = 0;
  for (; number < most_masks; ++number) {
    const fs::path file = folder / (image + "_" + bop_digits(number) + ".png");
    if (!fs::exists(file, error)) break;
    objects.setTo(number + 1, read_labels(file, size) != 0);
  }
  return number ? std::optional(objects) : std::nullopt;
}

/// Colour, or grey where there is no colour.
fs::path colour_of(const fs::path& scene, const std::string& name) {
  std::error_code error;
  for (const char* folder : {"rgb", "gray"})
    for (const char* extension : {".png", ".jpg", ".tif"})
      if (const fs::path file = scene / folder / (name + extension); fs::exists(file, error)) return file;
  throw InputError((scene / "rgb" / (name + ".png")).string() +
                   ": does not exist, nor is there one in gray/, nor one that ends in .jpg or .tif");
}

}  // namespace

std::vector<BopImage> find_bop_images(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> scenes;
  if (fs::exists(folder / bop_cameras_file, error)) {
    scenes.push_back(folder);
  } else {
    fs::directory_iterator entry(folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
      std::error_code ignored;
      if (fs::exists(entry->path() / bop_cameras_file, ignored)) scenes.push_back(entry->path());
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
    for (const int number : bop_image_numbers(scene))
      images.push_back({scene, number, scene / "depth" / (bop_digits(number) + ".png")});
  }
  return images;
}

std::string bop_name(const BopImage& image) { return scene_name(image.scene) + "_" + bop_digits(image.number); }

ConvertedScene read_bop_image(const BopImage& image, const ReadOptions& options) {
  const std::string name = bop_digits(image.number);
  LayoutImages images = read_images(image.depth, colour_of(image.scene, name));
  const cv::Size size = images.depth.size();
  const CameraFile own = read_bop_camera(image.scene, image.number, size);
  const fs::path masks = image.scene / "mask_visib";
  if (const auto objects = read_masks(masks, name, size)) images.label = labels_from(masks, *objects, images.depth);
  return scene_of(images, options.camera.value_or(own), own.depth_scale.value(), image.depth, options);
}

}  // namespace gestalt
