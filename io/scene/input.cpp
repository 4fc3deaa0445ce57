// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/input.h"

#include <algorithm>

#include "colour_beside.h"
#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/scene_format.h"

namespace gestalt {

namespace fs = std::filesystem;

cv::Mat_<float> depth_in_metres(const cv::Mat_<std::uint16_t>& raw, double scale) {
  cv::Mat_<float> depth(raw.size());
  const auto* first = raw.ptr<std::uint16_t>();
  // In double, so that a whole number of millimetres becomes the nearest float.
  std::transform(first, first + raw.total(), depth.ptr<float>(), [&](std::uint16_t d) { return float(d * scale); });
  return depth;
}

Input read_scene(const fs::path& path, const ReadOptions& options) {
  const SceneFormat* format = scene_format_of(path);
  std::error_code ignored;
  if (!format && fs::is_regular_file(path, ignored)) refuse_non_scene(path, "a depth image");
  // What is not a scene by its names is read as the commonest of its sort, whose reader says what is missing.
  if (!format) format = find_scene_format(fs::is_directory(path, ignored) ? "scene" : "pcd");
  Input input = format->read(path, options);
  if (!format->extension.empty()) {
    if (!options.colour.empty())
      set_colour(options.colour, path, input);
    else if (!input.frame.has_colour())
      add_colour_beside(path, input);
  }
  input.path = path;
  input.frame.name = scene_name(path);  // messages until here name the path
  return input;
}

}  // namespace gestalt
