// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "image_set.h"

#include <algorithm>

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/depth_reading.h"
#include "gestalt/io/scene/image_file.h"
#include "gestalt/io/scene/image_frame.h"
#include "gestalt/io/scene/natural_order.h"
#include "gestalt/io/scene/png_file.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

std::string text(cv::Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

void check_size(const fs::path& file, cv::Size size, cv::Size depth) {
  if (size != depth)
    throw InputError(file.string() + ": is " + text(size) + ", its depth image is " + text(depth) +
                     "; register the images to the same size");
}

}  // namespace

LayoutImages read_images(const fs::path& depth, const fs::path& colour) {
  LayoutImages images;
  images.depth = read_depth_png(depth);
  images.depth.setTo(0, images.depth == 65535);
  if (cv::countNonZero(images.depth) == 0)
    throw InputError(depth.string() + ": no pixel has a measurement (all are 0)");
  if (!colour.empty()) {
    images.colour = read_colour_image(colour, images.notes);
    check_size(colour, images.colour.size(), images.depth.size());
  }
  return images;
}

CameraFile camera_of_layout(const Camera& camera, cv::Size size, const fs::path& depth, const ReadOptions& options) {
  if (options.camera) return *options.camera;
  if (size != cv::Size(camera.width, camera.height))
    throw InputError(depth.string() + ": is " + text(size) + ", the camera is for " +
                     text({camera.width, camera.height}) + "; give --camera with the intrinsics of these images");
  return camera;
}

ConvertedScene scene_of(const LayoutImages& images, CameraFile camera, double scale_of_layout, const fs::path& depth,
                        const ReadOptions& options) {
  camera.depth_scale = camera.depth_scale.value_or(scale_of_layout);
  DepthReading reading = depth_reading(images.depth, options, camera);
  const double scale = reading.unit.metres;
  if (scale == scale_of_layout && !options.depth_scale) reading.unit.from = "as the layout has it";
  Input input;
  input.path = depth;
  input.ground_truth = images.label;
  input.notes = images.notes;
  set_frame_of_images(input, depth.string(), images.colour, std::move(reading), camera, depth);
  return converted(input, scale);
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
  if (files.empty()) throw InputError(folder.string() + ": contains no PNG image");
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
                         std::to_string(v) + "; objects are numbered from 1 to " + std::to_string(most));
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
