// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "gestalt/tests/environment/temporary_folder.h"

namespace gestalt::test {

/// Four labelled scenes of things on a table, 320x240, made once for all tests: a folder with camera.yaml.
const std::filesystem::path& synthetic_scenes();

/// One of them.
std::filesystem::path synthetic_scene(int index = 0);

inline constexpr int small_width = 80;
inline constexpr int small_height = 60;

/// A camera.yaml for images of 80x60, with another focal length where one is given.
std::string small_camera(const std::string& fx = "75");

/// A wall 1 m in front of the camera, in millimetres.
cv::Mat_<std::uint16_t> small_wall();

/// Writes a scene folder: depth.png, a grey rgb.png of its size and camera.yaml of 80x60.
std::filesystem::path write_scene(const std::filesystem::path& folder, const cv::Mat& depth);

/// Writes any image that PNG can hold.
void write_image(const std::filesystem::path& file, const cv::Mat& image);

/// Cuts a file off after a share of its bytes.
void truncate(const std::filesystem::path& file, double share);

/// A point with its colour, 0x00RRGGBB.
struct CloudPoint {
  cv::Vec3f position;
  std::uint32_t colour;
};

/// A binary PCD with the fields rgb x y z.
std::string pcd(const std::vector<CloudPoint>& points, int width, int height);

/// The points of a scene folder as its camera sees them, row by row; those without depth are not numbers.
std::vector<CloudPoint> points_of(const std::filesystem::path& scene);

}  // namespace gestalt::test
