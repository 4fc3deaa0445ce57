// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "image_set.h"

#include <algorithm>

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/depth_plausibility.h"
#include "gestalt/io/scene/image_file.h"
#include "gestalt/io/scene/natural_order.h"
#include "gestalt/io/scene/png_file.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

std::string text(cv::Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

void check_size(const fs::path& file, cv::Size size, cv::Size depth) {
  if (size != depth)
    throw InputError(file.string() + ": is " + text(size) + ", its depth image is " + text(depth) +
                     "; register the images to one size");
}

}  // namespace

SceneImages read_images(const fs::path& depth, const fs::path& colour, Camera& camera) {
  SceneImages images;
  images.depth = read_depth_png(depth);
  const cv::Size size = images.depth.size();
  if (camera.width == 0) camera.width = size.width, camera.height = size.height;
  if (size != cv::Size(camera.width, camera.height))
    throw InputError(depth.string() + ": is " + text(size) + ", the camera is for " +
                     text({camera.width, camera.height}) + "; give --camera with the intrinsics of these images");
  if (cv::countNonZero(images.depth) == 0)
    throw InputError(depth.string() + ": no pixel has a measurement (all are 0)");
  if (!colour.empty()) {
    images.colour = read_colour_image(colour);
    check_size(colour, images.colour.size(), size);
  }
  return images;
}

double scale_of(const ReadOptions& options, double of_layout) {
  if (options.depth_scale) return *options.depth_scale;
  return options.camera ? options.camera->depth_scale.value_or(of_layout) : of_layout;
}

void question(ConvertedScene& scene, const fs::path& depth, const ReadOptions& options) {
  scene.images.depth.setTo(0, scene.images.depth == 65535);  // "no measurement" with many
  const bool told = options.depth_scale || (options.camera && options.camera->depth_scale);
  DepthReading reading{depth_in_metres(scene.images.depth, scene.depth_scale),
                       {scene.depth_scale, told ? "as told" : "as the layout has it", told},
                       true,
                       DepthKind::plain};
  question_depth(depth.string(), reading, scene.camera, scene.warnings);
}

cv::Mat_<std::uint16_t> read_labels(const fs::path& file, cv::Size size) {
  cv::Mat_<std::uint16_t> labels = read_label_png(file);
  check_size(file, labels.size(), size);
  return labels;
}

std::vector<fs::path> png_files(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    if (entry->path().extension() == ".png") files.push_back(entry->path());
  if (error) throw InputError(folder.string() + ": cannot be listed: " + error.message());
  if (files.empty()) throw InputError(folder.string() + ": holds no PNG image");
  std::sort(files.begin(), files.end(),
            [](const fs::path& a, const fs::path& b) { return natural_less(a.string(), b.string()); });
  return files;
}

cv::Mat_<std::uint16_t> labels_of_objects(const cv::Mat_<std::uint16_t>& objects,
                                          const cv::Mat_<std::uint16_t>& depth) {
  constexpr int most = 6552;  // 10 (6552 + 1) is the largest multiple of ten in 16 bits
  cv::Mat_<std::uint16_t> labels(objects.size(), std::uint16_t{0});
  for (int v = 0; v < labels.rows; ++v)
    for (int u = 0; u < labels.cols; ++u) {
      if (depth(v, u) == 0) continue;
      const int object = objects(v, u);
      if (object > most)
        throw InputError("has object number " + std::to_string(object) + " at column " + std::to_string(u) + ", row " +
                         std::to_string(v) + "; objects are counted from 1 to " + std::to_string(most));
      labels(v, u) = std::uint16_t(object == 0 ? 1 : 10 * (object + 1));
    }
  return labels;
}

cv::Mat_<std::uint16_t> labels_from(const fs::path& annotation, const cv::Mat_<std::uint16_t>& objects,
                                    const cv::Mat_<std::uint16_t>& depth) {
  try {
    return labels_of_objects(objects, depth);
  } catch (const InputError& error) {
    throw InputError(annotation.string() + ": " + error.what());
  }
}

}  // namespace gestalt
