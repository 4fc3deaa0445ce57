// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <locale>
#include <map>
#include <sstream>
#include <utility>

#include "camera_info.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"
#include "gestalt/core/base/suggest.h"
#include "gestalt/io/scene/input.h"
#include "most_pixels.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> keys{"width", "height", "fx", "fy", "cx", "cy", "depth_scale"};

/// Takes the numbers out of a YAML map and collects what is wrong with them.
class Numbers {
 public:
  Numbers(fs::path file, const YAML::Node& root) : file_(std::move(file)) {
    if (!root.IsMap()) {
      complain({}, "is no camera file; write width, height, fx, fy, cx and cy, each as 'name: number'");
      check();
    }
    for (const auto& entry : root) {
      const YAML::Mark mark = entry.first.Mark();
      if (!entry.first.IsScalar()) {
        complain(mark, "a key must be a word");
        continue;
      }
      const std::string key = entry.first.Scalar();
      if (std::find(keys.begin(), keys.end(), key) == keys.end())
        complain(mark, "unknown key '" + key + "'" + did_you_mean(key, keys));
      else if (!entries_.emplace(key, std::pair(entry.second, mark)).second)
        complain(mark, "'" + key + "' stands here a second time; keep one");
    }
  }

  /// The number under a key, which must lie in [low, high]; meaning is for messages. Nothing when it is wrong.
  template <class Number>
  std::optional<Number> read(const std::string& key, Number low, Number high, const std::string& meaning) {
    const auto found = entries_.find(key);
    if (found == entries_.end()) {
      complain({}, "'" + key + "' is missing: " + meaning);
      return std::nullopt;
    }
    const auto& [node, mark] = found->second;
    const std::string text = node.IsScalar() ? node.Scalar() : "";
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && end == text.data() + text.size() && value >= low && value <= high) return value;
    std::ostringstream message;
    message.imbue(std::locale::classic());
    message << key << (node.IsScalar() ? " is '" + text + "'" : " has no number") << "; it must be "
            << (std::is_integral_v<Number> ? "a whole number" : "a number") << " from " << low << " to " << high << ": "
            << meaning;
    complain(node.IsScalar() ? node.Mark() : mark, message.str());
    return std::nullopt;
  }

  bool has(const std::string& key) const { return entries_.count(key) > 0; }

  /// Throws what was collected.
  void check() const {
    if (!errors_.empty()) throw InputError(errors_);
  }

  void complain(const YAML::Mark& mark, const std::string& message) {  // {} is the file's start
    errors_ += (errors_.empty() ? "" : "\n") + file_.string() + ":" + std::to_string(mark.line + 1) + ":" +
               std::to_string(mark.column + 1) + ": " + message;
  }

 private:
  fs::path file_;
  std::map<std::string, std::pair<YAML::Node, YAML::Mark>> entries_;
  std::string errors_;
};

YAML::Node parse(const fs::path& file) {
  constexpr std::size_t longest = 1 << 16;
  const std::string text = read_bytes(file, longest);
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw InputError(file.string() + ":" + std::to_string(error.mark.line + 1) + ":" +
                     std::to_string(error.mark.column + 1) + ": is no YAML: " + error.msg);
  }
}

}  // namespace

CameraFile read_camera(const fs::path& file) {
  constexpr int longest_side = 1 << 20;
  // Beyond these focal lengths single precision has no useful points.
  constexpr double shortest_focus = 0.01, longest_focus = 1e7;

  const YAML::Node root = parse(file);
  if (is_camera_info(root)) return read_camera_info(file, root);
  Numbers numbers(file, root);
  const auto width = numbers.read("width", 1, longest_side, "columns of the images");
  const auto height = numbers.read("height", 1, longest_side, "rows of the images");
  const auto fx = numbers.read("fx", shortest_focus, longest_focus, "focal length in pixel widths");
  const auto fy = numbers.read("fy", shortest_focus, longest_focus, "focal length in pixel heights");
  const auto cx = numbers.read("cx", 0.0, double(width.value_or(longest_side)),
                               "column of the principal point, which must lie in the image");
  const auto cy = numbers.read("cy", 0.0, double(height.value_or(longest_side)),
                               "row of the principal point, which must lie in the image");
  CameraFile result;
  if (numbers.has("depth_scale"))
    result.depth_scale = numbers.read("depth_scale", 1e-6, 1.0, "metres per unit of depth.png, 0.001 for millimetres");
  // camera.json of BOP has the same keys, but millimetres for each unit: 1, 0.1, ... No depth of 16 bits has
  // centimetres.
  constexpr double coarsest = 0.01;
  if (root.Style() == YAML::EmitterStyle::Flow && result.depth_scale >= coarsest) *result.depth_scale /= 1000;
  if (width && height && std::int64_t{*width} * *height > most_pixels)
    numbers.complain({}, "width x height is more than 2^26 pixels; such images cannot be read");
  numbers.check();
  result.camera = {*width, *height, *fx, *fy, *cx, *cy};
  result.file = file;
  return result;
}

std::optional<fs::path> find_camera_file(const fs::path& scene) {
  std::error_code error;
  fs::path folder = fs::absolute(scene, error).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();
  if (!fs::is_directory(folder, error)) folder = folder.parent_path();
  for (;; folder = folder.parent_path()) {
    const fs::path file = folder / "camera.yaml";
    if (fs::exists(file, error)) return file;
    if (folder == folder.parent_path()) return std::nullopt;
  }
}

}  // namespace gestalt
