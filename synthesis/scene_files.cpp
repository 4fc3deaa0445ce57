// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <nlohmann/json.hpp>

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

}  // namespace

void write_scene(const SyntheticScene& scene, const std::filesystem::path& folder) {
  const OutputPath place = OutputPath(folder) / scene.frame.name;
  write_files({{place / "objects.json", objects_text(scene.objects)}});
  write_scene_folder(place, {scene.frame.colour, depth_in_millimetres(scene.frame), scene.ground_truth});
}

}  // namespace gestalt
