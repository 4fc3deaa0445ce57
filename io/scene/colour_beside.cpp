// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "colour_beside.h"

#include "colour_image.h"
#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/image_file.h"
#include "scene_camera.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

/// False, and nothing changed, where the image is not of the same view.
bool take_colour(const fs::path& file, const cv::Mat& colour, Input& input) {
  const cv::Size size = input.frame.depth.size();
  if (!same_aspect(colour.size(), size)) return false;
  input.frame.colour = colour.size() == size ? colour : resized(colour, size);
  input.colour_from = file.string();
  return true;
}

std::string sizes(const fs::path& file, const cv::Mat& colour, const fs::path& scene, const Input& input) {
  return file.string() + ": is " + text(colour.size()) + ", the view of " + scene.filename().string() + " is " +
         text(input.frame.depth.size());
}

}  // namespace

void add_colour_beside(const fs::path& scene, Input& input) {
  std::error_code ignored;
  for (const char* extension : {".png", ".jpg", ".jpeg", ".PNG", ".JPG", ".JPEG"}) {
    const fs::path file = fs::path(scene).replace_extension(extension);
    if (!fs::is_regular_file(file, ignored) || is_depth_image(file)) continue;
    const cv::Mat colour = read_colour_image(file, input.notes);
    if (take_colour(file, colour, input))
      input.notes.push_back(
          "has no colour; the image of the same name beside it is used as the colour of the same view");
    else
      input.warnings.push_back(sizes(file, colour, scene, input) +
                               "; not used as its colour; register the two to use it");
    return;
  }
}

void set_colour(const fs::path& image, const fs::path& scene, Input& input) {
  const cv::Mat colour = read_colour_image(image, input.notes);
  if (!take_colour(image, colour, input))
    throw InputError(sizes(image, colour, scene, input) + "; register the two, or remove the colour image");
}

}  // namespace gestalt
