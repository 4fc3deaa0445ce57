// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "resumption.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "gestalt/core/base/digest.h"
#include "gestalt/core/base/error.h"
#include "gestalt/io/result/result.h"
#include "gestalt/io/result/result_file.h"
#include "gestalt/io/scene/scene_files.h"
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
bool is_of_results(const fs::path& file) {
  const std::string name = file.filename().string();
  return result_names().contains(name) || name.starts_with(".gestalt-");
}

}  // namespace

std::string scene_identity(const fs::path& scene) {
  std::error_code error;
  std::string text = fs::absolute(scene, error).lexically_normal().string();
  for (const fs::path& file : scene_files(scene))
    if (!is_of_results(file) && fs::file_size(file, error) <= largest_image)
      text += '\n' + file.filename().string() + ' ' + content_of(file);
  return digest(text);
}

bool is_segmented(const fs::path& folder, const std::string& identity, const std::vector<std::string>& wanted) {
  std::error_code error;
  if (!fs::is_regular_file(folder / "result.json", error)) return false;
  try {
    const json result = read_result_content(folder / "result.json");
    const auto files = result.at("files").get<std::map<std::string, std::string>>();
    const auto is_whole = [&](const auto& file) { return content_of(folder / file.first) == file.second; };
    return result.at("config").at("identity") == identity && std::all_of(files.begin(), files.end(), is_whole) &&
           std::all_of(wanted.begin(), wanted.end(), [&](const std::string& name) { return files.contains(name); });
  } catch (const InputError&) {
    return false;
  } catch (const json::exception&) {
    return false;
  }
}

}  // namespace gestalt::app
