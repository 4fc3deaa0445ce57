// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/dataset/convert.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

#include "gestalt/core/base/error.h"
#include "gestalt/core/pipeline/learning_set.h"
#include "gestalt/io/scene/natural_order.h"
#include "gestalt/io/scene/png_file.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

constexpr Camera osd_camera{640, 480, 525, 525, 319.5, 239.5};
constexpr std::array<const char*, 3> osd_folders{"disparity", "image_color", "annotation"};

/// A range of scene numbers of the database, both ends included.
struct CategoryRange {
  const char* set;
  int first;
  int last;
  const char* category;
};

// From the readme of OSD 0.2.
constexpr std::array<CategoryRange, 10> osd_categories{{{"learn", 0, 16, "boxes"},
                                                        {"learn", 17, 24, "stacked_boxes"},
                                                        {"learn", 25, 32, "occluded_objects"},
                                                        {"learn", 33, 44, "cylindric_objects"},
                                                        {"test", 0, 15, "boxes"},
                                                        {"test", 16, 23, "stacked_boxes"},
                                                        {"test", 24, 30, "occluded_objects"},
                                                        {"test", 31, 42, "cylindric_objects"},
                                                        {"test", 43, 54, "mixed_objects"},
                                                        {"test", 55, 65, "complex_scene"}}};

std::string text(cv::Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

/// Throws unless the file is there; the images of a scene have one name.
const fs::path& present(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error))
    throw InputError(
        file.string() +
        ": does not exist; every scene needs an image of its name in disparity, image_color and annotation");
  return file;
}

template <class Image>
Image read_of_size(const fs::path& file, Image (*read)(const fs::path&), cv::Size size) {
  Image image = read(present(file));
  if (image.size() != size)
    throw InputError(file.string() + ": is " + text(image.size()) + ", its disparity image is " + text(size) +
                     "; take the three images of one release");
  return image;
}

}  // namespace

std::vector<std::string> find_osd_scenes(const fs::path& release) {
  std::set<std::string> names;
  for (const char* folder : osd_folders) {
    std::error_code error;
    if (!fs::is_directory(release / folder, error))
      throw InputError(
          (release / folder).string() +
          ": is no folder; give the folder of the OSD release that holds disparity, image_color and annotation");
    for (fs::directory_iterator entry(release / folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error))
      if (entry->path().extension() == ".png") names.insert(entry->path().stem().string());
    if (error) throw InputError((release / folder).string() + ": cannot be listed: " + error.message());
  }
  if (names.empty())
    throw InputError(release.string() + ": its disparity, image_color and annotation hold no PNG image");
  std::vector<std::string> sorted(names.begin(), names.end());
  std::sort(sorted.begin(), sorted.end(), natural_less);
  return sorted;
}

ConvertedScene read_osd_scene(const fs::path& release, const std::string& name,
                              const std::optional<CameraFile>& camera) {
  const std::string image = name + ".png";
  const fs::path depth_file = release / "disparity" / image;
  ConvertedScene scene;
  scene.camera = camera ? camera->camera : osd_camera;
  scene.images.depth = read_depth_png(present(depth_file));
  const cv::Size size = scene.images.depth.size();
  if (size != cv::Size(scene.camera.width, scene.camera.height))
    throw InputError(depth_file.string() + ": is " + text(size) + ", the camera is for " +
                     text({scene.camera.width, scene.camera.height}) + "; give --camera with the intrinsics of " +
                     "these images");
  if (cv::countNonZero(scene.images.depth) == 0)
    throw InputError(depth_file.string() + ": no pixel has a measurement (all are 0)");
  scene.images.colour = read_of_size(release / "image_color" / image, read_colour_png, size);
  const fs::path annotation = release / "annotation" / image;
  try {
    scene.images.label = labels_of_objects(read_of_size(annotation, read_label_png, size), scene.images.depth);
  } catch (const InputError& error) {
    const std::string message = error.what();
    throw InputError(message.starts_with(annotation.string()) ? message : annotation.string() + ": " + message);
  }
  scene.objects = count_objects(scene.images.label);
  return scene;
}

ConvertedScene read_labelled_cloud(const fs::path& file, LabelKind labels, const std::optional<CameraFile>& camera) {
  const Input input = read_scene(file, camera);
  if (input.ground_truth.empty())
    throw InputError(file.string() + ": has no field label; give clouds with ground truth, a label for each point");
  ConvertedScene scene = converted(input);
  if (labels == LabelKind::objects) scene.images.label = labels_of_objects(input.ground_truth, scene.images.depth);
  scene.objects = count_objects(scene.images.label);
  if (scene.objects == 0)
    throw InputError(file.string() + ": its labels name no object; " +
                     (labels == LabelKind::objects
                          ? "all are 0, which is background"
                          : "objects are 20 to 29, 30 to 39 and so on. Where they are counted 1, 2, 3, ..., as in the "
                            "clouds of OSD 0.2, give --labels objects"));
  return scene;
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

OsdScene osd_scene(std::string_view name) {
  for (const CategoryRange& range : osd_categories) {
    const std::string_view set = range.set;
    if (!name.starts_with(set)) continue;
    int number = -1;
    const char* const end = name.data() + name.size();
    const auto [read, error] = std::from_chars(name.data() + set.size(), end, number);
    if (error == std::errc{} && read == end && number >= range.first && number <= range.last)
      return {range.set, range.category};
  }
  return {"scenes", ""};
}

}  // namespace gestalt
