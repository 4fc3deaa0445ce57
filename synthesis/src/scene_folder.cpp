// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <fstream>
#include <iomanip>
#include <locale>
#include <sstream>

#include "gestalt/error.h"
#include "gestalt/output_file.h"
#include "gestalt/synthesis.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

std::string read_all(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw InputError(file.string() + ": cannot be read; check that it is a file and its permission");
  return text.str();
}

}  // namespace

void write_scene(const SyntheticScene& scene, const fs::path& folder) {
  cv::Mat_<std::uint16_t> millimetres(scene.frame.depth.size());
  for (int v = 0; v < millimetres.rows; ++v)
    for (int u = 0; u < millimetres.cols; ++u)
      millimetres(v, u) = std::uint16_t(std::lround(1000.0 * double(scene.frame.depth(v, u))));
  const fs::path place = folder / scene.frame.name;
  write_png(place / "rgb.png", scene.frame.colour);
  write_png(place / "label.png", scene.ground_truth);
  write_png(place / "depth.png", millimetres);  // last: a folder with depth is a whole scene
}

void write_camera(const Camera& camera, const fs::path& folder) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(17)
       << "# pinhole intrinsics of every scene here (pixels); depth_scale: metres per unit of depth.png\n"
       << "width: " << camera.width << "\nheight: " << camera.height << "\nfx: " << camera.fx << "\nfy: " << camera.fy
       << "\ncx: " << camera.cx << "\ncy: " << camera.cy << "\ndepth_scale: 0.001\n";
  const fs::path file = folder / "camera.yaml";
  if (fs::exists(file) && read_all(file) != text.str())
    throw OutputError(file.string() + ": the folder holds scenes of another camera; choose another --output");
  write_file(file, text.str());
}

void merge_categories(const fs::path& file, const std::map<std::string, std::string>& category_of_scene) {
  static const std::string header = "scene,category";
  std::map<std::string, std::string> rows;
  if (fs::exists(file)) {
    std::istringstream in(read_all(file));
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      const auto fail = [&](const std::string& why) {
        throw InputError(file.string() + ":" + std::to_string(number) + ": " + why +
                         "; correct the file or choose another --output");
      };
      if (number == 1) {
        if (line != header) fail("expected the header '" + header + "', found '" + line + "'");
      } else if (!line.empty()) {
        const std::size_t comma = line.find(',');
        if (comma == std::string::npos || comma == 0) fail("expected 'scene,category', found '" + line + "'");
        rows[line.substr(0, comma)] = line.substr(comma + 1);
      }
    }
  }
  for (const auto& [scene, category] : category_of_scene) rows[scene] = category;
  std::string text = header + '\n';
  for (const auto& [scene, category] : rows) text += scene + ',' + category + '\n';
  write_file(file, text);
}

}  // namespace gestalt
