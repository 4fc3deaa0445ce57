// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/scene_folder.h"

#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>
#include <utility>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"
#include "gestalt/core/base/output_file.h"
#include "gestalt/io/scene/png_codec.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t largest_text = std::uintmax_t{1} << 28;  // bytes

std::string camera_text(const Camera& camera, double depth_scale = 0.001) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(17)
       << "# pinhole intrinsics of every scene here (pixels); depth_scale: metres per unit of depth.png\n"
       << "width: " << camera.width << "\nheight: " << camera.height << "\nfx: " << camera.fx << "\nfy: " << camera.fy
       << "\ncx: " << camera.cx << "\ncy: " << camera.cy << "\ndepth_scale: " << std::setprecision(6) << depth_scale
       << "\n";
  return text.str();
}

/// depth.png comes last: a folder with depth is a whole scene.
std::vector<OutputFile> image_files(const OutputPath& folder, const SceneImages& images) {
  std::vector<OutputFile> files;
  if (!images.colour.empty()) files.push_back({folder / "rgb.png", encode_png(images.colour)});
  if (!images.label.empty()) files.push_back({folder / "label.png", encode_png(images.label)});
  files.push_back({folder / "depth.png", encode_png(images.depth)});
  return files;
}

}  // namespace

cv::Mat_<std::uint16_t> depth_in_units(const Frame& frame, double metres) {
  cv::Mat_<std::uint16_t> units(frame.depth.size());
  for (int v = 0; v < units.rows; ++v)
    for (int u = 0; u < units.cols; ++u) {
      const double depth = std::round(double(frame.depth(v, u)) / metres);
      if (depth > std::numeric_limits<std::uint16_t>::max())
        throw InputError(frame.name + ": has a depth of " + std::to_string(frame.depth(v, u)) +
                         " m; 16 bits of this unit reach " + std::to_string(65535 * metres) +
                         " m, remove points beyond that");
      units(v, u) = std::uint16_t(depth);
    }
  return units;
}

cv::Mat_<std::uint16_t> depth_in_millimetres(const Frame& frame) { return depth_in_units(frame, 0.001); }

void write_scene_folder(const OutputPath& folder, const SceneImages& images, std::vector<OutputFile> others) {
  for (OutputFile& image : image_files(folder, images)) others.push_back(std::move(image));
  write_files(others);
}

void write_scene_folder(const OutputPath& folder, const SceneImages& images, const Camera& camera, double depth_scale) {
  std::vector<OutputFile> files = image_files(folder, images);
  files.insert(files.begin(), {folder / "camera.yaml", camera_text(camera, depth_scale)});
  write_files(files);
}

void write_camera(const Camera& camera, const OutputPath& folder) {
  const std::string text = camera_text(camera);
  const OutputPath output = folder / "camera.yaml";
  const fs::path file = output.path();
  update_file(output, [&] {
    if (fs::exists(file) && read_bytes(file, largest_text) != text)
      throw OutputError(file.string() + ": the folder contains scenes of another camera; choose another --output");
    return text;
  });
}

namespace {

constexpr const char* categories_header = "scene,category";

/// The categories by scene of a file of merge_categories(); none where there is no file.
std::map<std::string, std::string> read_rows(const fs::path& file) {
  std::map<std::string, std::string> rows;
  if (!fs::exists(file)) return rows;
  std::istringstream in(read_bytes(file, largest_text));
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const auto fail = [&](const std::string& why) {
      throw InputError(file.string() + ":" + std::to_string(number) + ": " + why +
                       "; correct the file or choose another --output");
    };
    if (number == 1) {
      if (line != categories_header)
        fail(std::string("expected the header '").append(categories_header).append("', found '").append(line) + "'");
    } else if (!line.empty()) {
      const std::size_t comma = line.find(',');
      if (comma == std::string::npos || comma == 0) fail("expected 'scene,category', found '" + line + "'");
      rows[line.substr(0, comma)] = line.substr(comma + 1);
    }
  }
  return rows;
}

}  // namespace

void merge_categories(const OutputPath& output, const std::map<std::string, std::string>& category_of_scene) {
  update_file(output, [&] {
    std::map<std::string, std::string> rows = read_rows(output.path());
    for (const auto& [scene, category] : category_of_scene) rows[scene] = category;
    std::string text = std::string(categories_header) + '\n';
    for (const auto& [scene, category] : rows) text.append(scene).append(",").append(category).append("\n");
    return text;
  });
}

}  // namespace gestalt
