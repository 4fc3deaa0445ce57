// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "resumption.h"

#include <algorithm>
#include <set>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"
#include "gestalt/core/base/hash.h"
#include "gestalt/core/plugin/fingerprint.h"
#include "gestalt/io/result/result_file.h"
#include "gestalt/io/scene/input.h"

namespace gestalt::app {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Of a model's file; "" of no path.
std::string hash_of(const fs::path& file) { return file.empty() ? "" : content_hash(read_bytes(file, largest_json)); }

/// The folder tells of files that were removed.
std::vector<fs::path> files_of(const fs::path& scene) {
  std::vector<fs::path> files;
  if (const auto camera = find_camera_file(scene)) files.push_back(*camera);
  if (fs::is_directory(scene))
    for (const fs::directory_entry& entry : fs::directory_iterator(scene)) files.push_back(entry.path());
  files.push_back(scene);
  return files;
}

}  // namespace

std::string run_identity(const json& config, const fs::path& model, const ReadingOptions& reading) {
  json values = config.at("values");
  values.erase("time_budget");
  return content_hash(std::string(GESTALT_VERSION) + '\n' + GESTALT_BUILD_FINGERPRINT + '\n' +
                      values.dump(-1, ' ', false, json::error_handler_t::replace) + '\n' + hash_of(model) + '\n' +
                      hash_of(reading.camera) + '\n' + text_of(reading));
}

bool is_segmented(const fs::path& scene, const fs::path& folder, const std::string& identity,
                  const std::vector<std::string>& wanted) {
  if (!fs::is_regular_file(folder / "result.json")) return false;
  const auto made = fs::last_write_time(folder / "result.json");
  const std::vector<fs::path> sources = files_of(scene);
  if (!std::all_of(sources.begin(), sources.end(), [&](const auto& file) { return fs::last_write_time(file) < made; }))
    return false;
  try {
    const json result = read_result_content(folder / "result.json");
    const auto files = result.at("files").get<std::set<std::string>>();
    const auto is_there = [&](const std::string& name) { return fs::is_regular_file(folder / name); };
    return result.value("input", "") == fs::absolute(scene).lexically_normal().string() &&
           result.at("config").value("identity", "") == identity && std::all_of(files.begin(), files.end(), is_there) &&
           std::all_of(wanted.begin(), wanted.end(), [&](const std::string& name) { return files.contains(name); });
  } catch (const InputError&) {
    return false;
  } catch (const json::exception&) {
    return false;
  }
}

}  // namespace gestalt::app
