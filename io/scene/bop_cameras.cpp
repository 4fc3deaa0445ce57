// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "bop_cameras.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

#include "camera_formats.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/json_file.h"

namespace gestalt {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::uintmax_t largest_cameras = std::uintmax_t{1} << 28;  // bytes
constexpr std::size_t number_digits = 6;                             // at most, of an image
constexpr const char* two_cameras = "has two cameras, with and without leading zeros; keep the one that is right";

json read_cameras(const fs::path& scene) {
  const fs::path file = scene / bop_cameras_file;
  json cameras = read_json(file, largest_cameras);
  if (!cameras.is_object() || cameras.empty())
    throw InputError(file.string() + ": is not a JSON map from image numbers to cameras; use the data set's own file");
  return cameras;
}

/// Keys of some data sets have leading zeros.
json entry_of(const json& cameras, int number, const std::function<void(const std::string&)>& fail) {
  json entry;
  std::string key = std::to_string(number);
  for (const std::size_t longest = std::max(key.size(), number_digits); key.size() <= longest; key.insert(0, "0")) {
    if (!cameras.contains(key)) continue;
    if (!entry.is_null()) fail(two_cameras);
    entry = cameras.at(key);
  }
  if (entry.is_null()) fail("has no camera; take the file of the data set, or give --camera FILE");
  return entry;
}

}  // namespace

std::vector<int> bop_image_numbers(const fs::path& scene) {
  std::vector<int> numbers;
  const json cameras = read_cameras(scene);
  for (const auto& [key, camera] : cameras.items()) {
    if (key.empty() || key.size() > number_digits || key.find_first_not_of("0123456789") != key.npos)
      throw InputError((scene / bop_cameras_file).string() + ": '" + key.substr(0, 40) +
                       "' is not the number of an image");
    numbers.push_back(std::stoi(key));
  }
  std::sort(numbers.begin(), numbers.end());
  if (const auto twice = std::adjacent_find(numbers.begin(), numbers.end()); twice != numbers.end())
    throw InputError((scene / bop_cameras_file).string() + ": " + std::to_string(*twice) + ": " + two_cameras);
  return numbers;
}

CameraFile read_bop_camera(const fs::path& scene, int number, cv::Size size) {
  const fs::path file = scene / bop_cameras_file;
  const json cameras = read_cameras(scene);
  const std::string key = std::to_string(number);
  const auto fail = [&](const std::string& what) { throw InputError(file.string() + ": " + key + ": " + what); };
  const json entry = entry_of(cameras, number, fail);
  const json k = entry.is_object() ? entry.value("cam_K", json()) : json();
  const auto is_number = [](const json& value) { return value.is_number(); };
  if (!k.is_array() || k.size() != 9 || !std::all_of(k.begin(), k.end(), is_number))
    fail("cam_K must be a list of 9 numbers");
  CameraFile camera(Camera{size.width, size.height, 0, 0, 0, 0});
  if (const std::string wrong = take_matrix(k.get<std::vector<double>>(), camera); !wrong.empty())
    fail("cam_K " + wrong);
  const Camera& c = camera.camera;
  const auto lies_in = [](double value, double low, double high) { return value >= low && value <= high; };
  if (!lies_in(c.fx, 0.01, 1e7) || !lies_in(c.fy, 0.01, 1e7) || !lies_in(c.cx, 0, size.width) ||
      !lies_in(c.cy, 0, size.height))
    fail("cam_K must have focal lengths from 0.01 to 1e7 pixels and its principal point in the image");
  const json scale = entry.value("depth_scale", json(1.0));  // millimetres a unit
  if (!scale.is_number() || !(scale.get<double>() >= 1e-3 && scale.get<double>() <= 1000))
    fail("depth_scale must be a number from 0.001 to 1000, millimetres for each unit of the depth image");
  camera.depth_scale = scale.get<double>() / 1000;
  camera.file = file;
  return camera;
}

std::string bop_digits(int number) {
  const std::string digits = std::to_string(number);
  return std::string(digits.size() < number_digits ? number_digits - digits.size() : 0, '0') + digits;
}

}  // namespace gestalt
