// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "resumption.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "gestalt/core/base/digest.h"
#include "gestalt/core/base/error.h"
#include "gestalt/io/result/result_file.h"
#include "gestalt/io/scene/input.h"
#include "scene_segmenter.h"

namespace gestalt::app {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::uintmax_t largest_image = std::uintmax_t{1} << 30;  // bytes

/// What stands for a file's content; also of one that cannot be read, as results do not follow from it then.
std::string content_of(const fs::path& file) {
  try {
    return file_digest(file);
  } catch (const InputError&) {
    return "unreadable";
  }
}

/// Results may be written into the scene's own folder.
bool is_of_scene(const fs::directory_entry& entry) {
  std::error_code error;
  static const std::set<std::string> of_results = result_names();
  const std::string name = entry.path().filename().string();
  return entry.is_regular_file(error) && entry.file_size(error) <= largest_image && !of_results.contains(name) &&
         name.find(".tmp") == std::string::npos;
}

/// A line of text for each file of a scene, in order of their names.
std::set<std::string> contents(const fs::path& scene) {
  std::set<std::string> lines;
  std::error_code error;
  if (!fs::is_directory(scene, error)) return {content_of(scene)};
  fs::directory_iterator entry(scene, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    if (is_of_scene(*entry)) lines.insert(entry->path().filename().string() + ' ' + content_of(entry->path()));
  return lines;
}

}  // namespace

std::string result_identity(const std::string& run, const fs::path& scene) {
  std::error_code error;
  std::string text = run + '\n' + fs::absolute(scene, error).lexically_normal().string();
  for (const std::string& line : contents(scene)) text += '\n' + line;
  if (const auto camera = find_camera_file(scene)) text += "\ncamera " + content_of(*camera);
  return digest(text);
}

bool is_segmented(const fs::path& folder, const std::string& identity, const std::vector<std::string>& wanted) {
  const auto is_there = [&](const std::string& name) {
    std::error_code error;
    return fs::is_regular_file(folder / name, error);
  };
  if (!is_there("result.json")) return false;
  try {
    const json result = read_result_content(folder / "result.json");
    const auto files = result.at("files").get<std::set<std::string>>();
    return result.at("config").at("identity") == identity && std::all_of(files.begin(), files.end(), is_there) &&
           std::all_of(wanted.begin(), wanted.end(), [&](const std::string& name) { return files.contains(name); });
  } catch (const InputError&) {
    return false;
  } catch (const json::exception&) {
    return false;
  }
}

}  // namespace gestalt::app
