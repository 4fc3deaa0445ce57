// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/dataset/osd_release.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/natural_order.h"
#include "image_set.h"

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

/// Throws unless the file is there; the images of a scene have one name.
const fs::path& present(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error))
    throw InputError(
        file.string() +
        ": does not exist; every scene needs an image of its name in disparity, image_color and annotation");
  return file;
}

}  // namespace

std::vector<std::string> find_osd_scenes(const fs::path& release) {
  std::set<std::string> names;
  for (const char* folder : osd_folders) {
    std::error_code error;
    if (!fs::is_directory(release / folder, error))
      throw InputError(
          (release / folder).string() +
          ": is not a folder; give the folder of the OSD release that holds disparity, image_color and annotation");
    for (fs::directory_iterator entry(release / folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error))
      if (entry->path().extension() == ".png") names.insert(entry->path().stem().string());
    if (error) throw InputError((release / folder).string() + ": cannot be listed: " + error.message());
  }
  if (names.empty())
    throw InputError(release.string() + ": its disparity, image_color and annotation contain no PNG image");
  std::vector<std::string> sorted(names.begin(), names.end());
  std::sort(sorted.begin(), sorted.end(), natural_less);
  return sorted;
}

ConvertedScene read_osd_scene(const fs::path& release, const std::string& name, const ReadOptions& options) {
  const std::string image = name + ".png";
  const auto file = [&](const char* folder) { return present(release / folder / image); };
  const fs::path depth = file("disparity"), colour = file("image_color"), annotation = file("annotation");
  LayoutImages images = read_images(depth, colour);
  const cv::Size size = images.depth.size();
  images.label = labels_from(annotation, read_labels(annotation, size), images.depth);
  return scene_of(images, camera_of_layout(osd_camera, size, depth, options), 0.001, depth, options);
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
