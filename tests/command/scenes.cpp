// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scenes.h"

#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "gestalt/io/scene/input.h"
#include "run_gestalt.h"

namespace gestalt::test {

namespace fs = std::filesystem;

const fs::path& synthetic_scenes() {
  static const TemporaryFolder folder;
  static const fs::path scenes = [] {
    const fs::path made = folder.path() / "scenes";
    const Outcome outcome = run_gestalt({"synthesize", "--category", "mixed_objects", "--seed", "1", "--count", "4",
                                         "--width", "320", "--height", "240", "--output", made});
    if (outcome.code != 0) throw std::runtime_error("no synthetic scenes: " + outcome.err);
    return made;
  }();
  return scenes;
}

fs::path synthetic_scene(int index) { return synthetic_scenes() / ("mixed_objects_1_00" + std::to_string(index)); }

std::string small_camera(const std::string& fx) {
  return "width: 80\nheight: 60\nfx: " + fx + "\nfy: 75\ncx: 39.5\ncy: 29.5\n";
}

cv::Mat_<std::uint16_t> small_wall() { return cv::Mat_<std::uint16_t>(small_height, small_width, std::uint16_t{1000}); }

fs::path write_scene(const fs::path& folder, const cv::Mat& depth) {
  fs::create_directories(folder);
  write_image(folder / "depth.png", depth);
  write_image(folder / "rgb.png", cv::Mat(depth.size(), CV_8UC3, cv::Scalar(90, 100, 110)));
  std::ofstream(folder / "camera.yaml") << small_camera();
  return folder;
}

void write_image(const fs::path& file, const cv::Mat& image) {
  if (!cv::imwrite(file, image)) throw std::runtime_error(file.string() + " cannot be written");
}

void truncate(const fs::path& file, double share) {
  fs::resize_file(file, std::uintmax_t(share * double(fs::file_size(file))));
}

std::string pcd(const std::vector<CloudPoint>& points, int width, int height) {
  std::string bytes = "VERSION 0.7\nFIELDS rgb x y z\nSIZE 4 4 4 4\nTYPE U F F F\nCOUNT 1 1 1 1\nWIDTH " +
                      std::to_string(width) + "\nHEIGHT " + std::to_string(height) +
                      "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + std::to_string(width * height) + "\nDATA binary\n";
  for (const CloudPoint& point : points) {
    bytes.append(reinterpret_cast<const char*>(&point.colour), sizeof point.colour);
    bytes.append(reinterpret_cast<const char*>(point.position.val), sizeof point.position.val);
  }
  return bytes;
}

std::vector<CloudPoint> points_of(const fs::path& scene) {
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  const Frame frame = read_scene(scene).frame;
  std::vector<CloudPoint> points;
  for (int v = 0; v < frame.height(); ++v)
    for (int u = 0; u < frame.width(); ++u) {
      const auto& bgr = frame.colour.at<cv::Vec3b>(v, u);
      const std::uint32_t colour = std::uint32_t(bgr[2]) << 16 | std::uint32_t(bgr[1]) << 8 | bgr[0];
      points.push_back({frame.depth(v, u) > 0 ? frame.points(v, u) : cv::Vec3f(none, none, none), colour});
    }
  return points;
}

}  // namespace gestalt::test
