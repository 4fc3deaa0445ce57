// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/dataset/ocid_sequence.h"

#include <algorithm>

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/natural_order.h"
#include "image_set.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

bool is_sequence(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder / "depth", error) && fs::is_directory(folder / "label", error);
}

std::vector<fs::path> find_sequences(const fs::path& release) {
  std::error_code error;
  std::vector<fs::path> sequences;
  if (is_sequence(release)) sequences.push_back(release);
  fs::recursive_directory_iterator entry(release, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (!entry->is_directory(ignored) || !is_sequence(entry->path())) continue;
    sequences.push_back(entry->path());
    entry.disable_recursion_pending();
  }
  if (error) throw InputError(release.string() + ": cannot be listed: " + error.message());
  if (sequences.empty())
    throw InputError(release.string() +
                     ": contains no folder with depth, rgb and label; give OCID or a sequence of it");
  std::sort(sequences.begin(), sequences.end(),
            [](const fs::path& a, const fs::path& b) { return natural_less(a.string(), b.string()); });
  return sequences;
}

/// Labels of OCID are 1 for what stands far behind, in sequences on a table 2 for that, then one for each object.
cv::Mat_<std::uint16_t> count_from_objects(const cv::Mat_<std::uint16_t>& labels, bool on_table) {
  const int background = on_table ? 2 : 1;
  cv::Mat_<std::uint16_t> objects(labels.size());
  std::transform(labels.begin(), labels.end(), objects.begin(),
                 [&](std::uint16_t label) { return std::uint16_t(std::max(int(label) - background, 0)); });
  return objects;
}

}  // namespace

std::vector<OcidFrame> find_ocid_frames(const fs::path& release) {
  std::vector<OcidFrame> frames;
  for (const fs::path& sequence : find_sequences(release)) {
    // Sequences on floor and table have the same names: the way to them tells them apart.
    std::string prefix;
    for (const fs::path& part : sequence.lexically_relative(release))
      if (part != ".") prefix += part.string() + "_";
    for (const fs::path& depth : png_files(sequence / "depth"))
      frames.push_back({sequence, depth, prefix + depth.stem().string()});
  }
  return frames;
}

ConvertedScene read_ocid_frame(const OcidFrame& frame, const ReadOptions& options) {
  const fs::path image = frame.depth.filename();
  Camera of_points;
  if (!options.camera) {
    // The release has no intrinsics, but a cloud of every frame.
    const fs::path cloud = frame.sequence / "pcd" / (image.stem().string() + ".pcd");
    std::error_code error;
    if (!fs::exists(cloud, error))
      throw InputError(cloud.string() +
                       ": does not exist; the camera is fitted to its points; without it give --camera");
    of_points = read_scene(cloud).frame.camera;
  }
  LayoutImages images = read_images(frame.depth, frame.sequence / "rgb" / image);
  const cv::Size size = images.depth.size();
  const fs::path label = frame.sequence / "label" / image;
  const std::string place = fs::absolute(frame.sequence).string();
  const bool on_table = place.find("table") != place.npos;
  images.label = labels_from(label, count_from_objects(read_labels(label, size), on_table), images.depth);
  return scene_of(images, camera_of_layout(of_points, size, frame.depth, options), 0.001, frame.depth, options);
}

}  // namespace gestalt
