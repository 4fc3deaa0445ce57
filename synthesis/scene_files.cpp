// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <iomanip>
#include <locale>
#include <nlohmann/json.hpp>
#include <sstream>

#include "gestalt/core/base/output_file.h"
#include "gestalt/io/scene/scene_folder.h"
#include "gestalt/synthesis/synthesis.h"

namespace gestalt {

namespace {

using Json = nlohmann::ordered_json;

/// To 10 micrometres, so that compilers agree.
Json vector_json(const Eigen::Vector3d& v) {
  Json numbers = Json::array();
  for (const double x : v) numbers.push_back(std::round(x * 1e5) / 1e5 + 0.0);  // no -0
  return numbers;
}

std::string objects_text(const std::vector<SyntheticObject>& objects) {
  Json all = Json::array();
  int number = 2;
  for (const SyntheticObject& object : objects) {
    Json axes = Json::array();
    for (int i = 0; i < 3; ++i) axes.push_back(vector_json(object.pose.linear().col(i)));
    all.push_back({{"object", number++},
                   {"shape", name_of(object.shape)},
                   {"centre", vector_json(object.pose.translation())},
                   {"axes", std::move(axes)},
                   {"size", vector_json(object.size)}});
  }
  return all.dump(1) + "\n";
}

/// Name tx ty tz qx qy qz qw, one frame a line.
std::string poses_text(const std::vector<SyntheticScene>& frames) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "# frame tx ty tz qx qy qz qw: metres, from the camera's frame to the world\n"
       << std::fixed << std::setprecision(6);
  for (const SyntheticScene& scene : frames) {
    const Eigen::Vector3d t = scene.camera_pose.translation();
    const Eigen::Quaterniond q(scene.camera_pose.linear());
    text << scene.frame.name << ' ' << t.x() << ' ' << t.y() << ' ' << t.z() << ' ' << q.x() << ' ' << q.y() << ' '
         << q.z() << ' ' << q.w() << '\n';
  }
  return text.str();
}

}  // namespace

void write_scene(const SyntheticScene& scene, const std::filesystem::path& folder) {
  const OutputPath place = OutputPath(folder) / scene.frame.name;
  write_scene_folder(place, {scene.frame.colour, depth_in_millimetres(scene.frame), scene.ground_truth},
                     {{place / "objects.json", objects_text(scene.objects)}});
}

void write_sequence(const std::vector<SyntheticScene>& frames, const std::filesystem::path& folder) {
  for (const SyntheticScene& scene : frames) write_scene(scene, folder);
  write_files({{OutputPath(folder) / "poses.txt", poses_text(frames)}});
}

}  // namespace gestalt
