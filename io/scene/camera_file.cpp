// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <boost/property_tree/xml_parser.hpp>
#include <sstream>
#include <tuple>
#include <utility>

#include "assignments.h"
#include "camera_formats.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"
#include "gestalt/io/scene/input.h"
#include "gestalt/io/scene/yaml_document.h"
#include "most_pixels.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& file, const YAML::Mark& mark, const std::string& what) {
  throw InputError(file.string() + ":" + std::to_string(mark.line + 1) + ":" + std::to_string(mark.column + 1) + ": " +
                   what);
}

/// "ROS camera_info (width, height, K, D); ...".
std::string known_formats() {
  std::string text;
  const auto add = [&](const auto& format) {
    text += (text.empty() ? "" : "; ") + format.name + " (" + format.keys + ")";
  };
  for (const CameraFormat& format : camera_formats()) add(format);
  for (const CameraTextFormat& format : camera_text_formats()) add(format);
  return text;
}

YAML::Node parse_yaml(const fs::path& file, const std::string& text) {
  try {
    return load_yaml_document(text);
  } catch (const YAML::Exception& error) {
    fail(file, error.mark.is_null() ? YAML::Mark() : error.mark, "is not valid YAML: " + error.msg);
  }
}

using Tree = boost::property_tree::ptree;

YAML::Node yaml_of(const Tree& tree) {
  YAML::Node node;
  if (tree.empty()) return YAML::Node(tree.data());
  for (const auto& [name, below] : tree)
    if (name != "<xmlattr>" && name != "<xmlcomment>") node.force_insert(name, yaml_of(below));
  return node.IsMap() ? node : YAML::Node(tree.data());  // attributes alone
}

/// OpenCV's FileStorage as XML, as if it were YAML.
YAML::Node parse_xml(const fs::path& file, const std::string& text) {
  constexpr std::ptrdiff_t most_tags = 2000;  // a camera has some twenty; nested ones take stack
  if (std::count(text.begin(), text.end(), '<') > most_tags) fail(file, {}, "is too large an XML file for a camera");
  Tree tree;
  std::istringstream in(text);
  try {
    read_xml(in, tree, boost::property_tree::xml_parser::no_comments);
  } catch (const boost::property_tree::xml_parser_error& error) {
    throw InputError(file.string() + ":" + std::to_string(error.line()) + ": is not valid XML: " + error.message());
  }
  const auto storage = tree.get_child_optional("opencv_storage");
  return yaml_of(storage ? *storage : tree);
}

const CameraFormat* format_of(const CameraEntries& entries) {
  const auto formats = camera_formats();
  const auto found = std::find_if(formats.begin(), formats.end(),
                                  [&](const CameraFormat& format) { return format.recognises(entries); });
  return found == formats.end() ? nullptr : &*found;
}

bool same(const CameraFile& a, const CameraFile& b) {
  const auto numbers = [](const CameraFile& file) {
    const Camera& c = file.camera;
    return std::tuple(c.width, c.height, c.fx, c.fy, c.cx, c.cy, file.depth_scale, file.lens.model,
                      file.lens.coefficients);
  };
  return numbers(a) == numbers(b);
}

/// A camera one level below: kalibr's cam0, or "color" of a RealSense. Several must be the same.
std::optional<CameraFile> read_nested(const fs::path& file, const YAML::Node& root, bool json) {
  constexpr std::size_t most = 256;
  std::optional<CameraFile> result;
  std::string name;
  if (root.size() > most) return result;
  for (const auto& entry : root) {
    if (!entry.first.IsScalar() || !entry.second.IsMap()) continue;
    CameraEntries entries(file, entry.second, json);
    const CameraFormat* format = format_of(entries);
    if (!format || (format == &camera_formats().back() && !entries.has("fx"))) continue;
    CameraFile found = format->read(entries);
    entries.check(format->name);
    if (result && !same(*result, found))
      fail(file, entry.first.Mark(),
           "holds several cameras ('" + name + "', '" + entry.first.Scalar() +
               "', ...); put the camera of these images in its own file");
    if (!result) name = entry.first.Scalar();
    result = std::move(found);
  }
  return result;
}

CameraFile read_entries(const fs::path& file, const YAML::Node& root, bool json) {
  const std::string unknown = "is not a camera file; it may be one of: " + known_formats();
  if (!root.IsMap()) fail(file, {}, unknown);
  CameraEntries entries(file, root, json);
  const CameraFormat* format = format_of(entries);
  // Our own keys are common words: a camera below them goes before.
  const bool own = format == &camera_formats().back();
  if (!format || (own && !entries.has("fx") && !entries.has("fy")))
    if (auto nested = read_nested(file, root, json)) return *std::move(nested);
  if (!format) fail(file, {}, unknown);
  CameraFile result = format->read(entries);
  entries.check(own ? "" : format->name);
  return result;
}

/// Text without a byte order mark; what Windows writes as UTF-16 becomes ASCII, as cameras have no other letters.
std::string plain_text(const std::string& bytes) {
  if (bytes.starts_with("\xef\xbb\xbf")) return bytes.substr(3);
  if (!bytes.starts_with("\xff\xfe") && !bytes.starts_with("\xfe\xff")) return bytes;
  std::string text;
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) text += bytes[bytes[0] == '\xff' ? i : i + 1];
  return text;
}

CameraFile read_any(const fs::path& file) {
  constexpr std::size_t longest = 1 << 16;
  const std::string text = plain_text(read_bytes(file, longest));
  for (const CameraTextFormat& format : camera_text_formats())
    if (format.recognises(text)) return format.read(file, text);
  if (is_assignments(text)) return read_entries(file, parse_yaml(file, yaml_of_assignments(text)), false);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool xml = first != text.npos && text[first] == '<', json = first != text.npos && text[first] == '{';
  return read_entries(file, xml ? parse_xml(file, text) : parse_yaml(file, text), json);
}

}  // namespace

CameraFile read_camera(const fs::path& file) {
  CameraFile result = read_any(file);
  result.file = file;
  if (!result.lens.distorts()) result.lens = {};
  const Camera& c = result.camera;
  if (std::int64_t{c.width} * c.height > most_pixels) fail(file, {}, "width x height exceeds the limit of 2^26 pixels");
  const auto inside = [](double centre, int size) { return centre >= 0 && (size == 0 || centre <= size); };
  if (!(c.fx >= 0.01 && c.fx <= 1e7 && c.fy >= 0.01 && c.fy <= 1e7) || !inside(c.cx, c.width) ||
      !inside(c.cy, c.height))
    fail(file, {}, "the focal lengths must be from 0.01 to 1e7 pixels, and the principal point in the image");
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
