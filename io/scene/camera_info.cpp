// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "camera_info.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "gestalt/core/base/error.h"
#include "most_pixels.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

/// The first of the keys that is there; ROS 1 and 2 differ in capitals.
YAML::Node any_of(const YAML::Node& root, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (const YAML::Node node = root[key]) return node;
  return YAML::Node(YAML::NodeType::Undefined);
}

class Reader {
 public:
  Reader(const fs::path& file, const YAML::Node& root) : file_(file), root_(root) {}

  int extent(std::initializer_list<const char*> keys) const {
    const YAML::Node node = any_of(root_, keys);
    const double value = node ? number(node) : 0;
    if (!(value >= 1 && value <= (1 << 20) && value == std::floor(value)))
      fail(node, std::string(*keys.begin()) + " must be a whole number of pixels from 1");
    return int(value);
  }

  /// The numbers of a list, or of the data of a matrix; empty where there is none.
  std::vector<double> numbers(std::initializer_list<const char*> keys) const {
    YAML::Node node = any_of(root_, keys);
    if (node && node.IsMap()) node = node["data"];
    std::vector<double> all;
    if (!node) return all;
    if (!node.IsSequence()) fail(node, std::string(*keys.begin()) + " must be a list of numbers");
    for (const YAML::Node& one : node) all.push_back(number(one));
    return all;
  }

  [[noreturn]] void fail(const YAML::Node& node, const std::string& what) const {
    const YAML::Mark mark = node ? node.Mark() : root_.Mark();
    throw InputError(file_.string() + ":" + std::to_string(mark.line + 1) + ":" + std::to_string(mark.column + 1) +
                     ": " + what);
  }

  double number(const YAML::Node& node) const {
    const std::string text = node.IsScalar() ? node.Scalar() : "";
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
      fail(node, "'" + text.substr(0, 40) + "' is no number");
    return value;
  }

 private:
  const fs::path& file_;
  const YAML::Node& root_;
};

}  // namespace

bool is_camera_info(const YAML::Node& root) {
  return root.IsMap() && any_of(root, {"camera_matrix", "image_width", "K", "k", "distortion_model"});
}

CameraFile read_camera_info(const fs::path& file, const YAML::Node& root) {
  const Reader reader(file, root);
  const std::vector<double> distortion = reader.numbers({"distortion_coefficients", "D", "d"});
  if (std::any_of(distortion.begin(), distortion.end(), [](double value) { return value != 0; }))
    reader.fail(any_of(root, {"distortion_coefficients", "D", "d"}),
                "the lens distorts; rectify the images (image_proc) and give a camera file with the intrinsics of P");
  const YAML::Node model = any_of(root, {"distortion_model"});
  if (model && model.IsScalar() && model.Scalar() == "equidistant")
    reader.fail(model, "an equidistant lens is no pinhole, even without coefficients; rectify the images");
  const std::vector<double> k = reader.numbers({"camera_matrix", "K", "k"});
  if (k.size() != 9) reader.fail(any_of(root, {"camera_matrix", "K", "k"}), "camera_matrix (K) must have 9 numbers");
  if (k[1] != 0) reader.fail(any_of(root, {"camera_matrix", "K", "k"}), "its axes are skew; our cameras have none");
  CameraFile result(Camera{reader.extent({"image_width", "width"}), reader.extent({"image_height", "height"}), k[0],
                           k[4], k[2], k[5]});
  const Camera& c = result.camera;
  if (!(c.fx >= 0.01 && c.fx <= 1e7 && c.fy >= 0.01 && c.fy <= 1e7 && c.cx >= 0 && c.cx <= c.width && c.cy >= 0 &&
        c.cy <= c.height) ||
      std::int64_t{c.width} * c.height > most_pixels)
    reader.fail(any_of(root, {"camera_matrix", "K", "k"}),
                "the focal lengths must be from 0.01 to 1e7 pixels, and the principal point in an image of up to 2^26");
  // No key of ROS, but one of our camera files.
  if (const YAML::Node scale = root["depth_scale"]) {
    result.depth_scale = reader.number(scale);
    if (!(*result.depth_scale >= 1e-6 && *result.depth_scale <= 1))
      reader.fail(scale, "depth_scale must be from 1e-06 to 1, metres per unit");
  }
  result.file = file;
  return result;
}

}  // namespace gestalt
