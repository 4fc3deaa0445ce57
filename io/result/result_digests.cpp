// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/result/result_digests.h"

#include <nlohmann/json.hpp>

#include "gestalt/core/base/digest.h"
#include "gestalt/core/base/error.h"
#include "gestalt/io/result/result_file.h"

namespace gestalt {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Names come from the file: only those of its own folder are looked at.
bool is_foreign(const fs::path& folder, const std::string& name, const json& digest) {
  const fs::path file = folder / name;
  std::error_code error;
  if (name.empty() || fs::path(name) != fs::path(name).filename() || !fs::is_regular_file(file, error)) return false;
  try {
    return digest != json(file_digest(file));
  } catch (const InputError&) {
    return true;  // nobody can tell
  }
}

/// "files" of a result that has digests; null of any other.
json digests_of(const json& content) {
  const auto files = content.find("files");
  return files != content.end() && files->is_object() ? *files : json();
}

}  // namespace

std::vector<std::string> foreign_files(const fs::path& result, const json& content) {
  std::vector<std::string> foreign;
  const json digests = digests_of(content);
  for (const auto& [name, digest] : digests.items())
    if (is_foreign(result.parent_path(), name, digest)) foreign.push_back(name);
  return foreign;
}

std::vector<std::string> own_files(const fs::path& result) {
  std::error_code error;
  if (!fs::is_regular_file(result, error)) return {};
  std::vector<std::string> own;
  try {
    const json digests = digests_of(read_result_content(result));
    for (const auto& [name, digest] : digests.items()) {
      const fs::path file = result.parent_path() / name;
      if (fs::path(name) == file.filename() && fs::is_regular_file(file, error) && digest == json(file_digest(file)))
        own.push_back(name);
    }
  } catch (const InputError&) {
    return {};  // of another program, or damaged
  }
  return own;
}

std::string warning_of_foreign_files(const fs::path& result, const json& content) {
  std::string names;
  for (const std::string& name : foreign_files(result, content)) names += (names.empty() ? "" : ", ") + name;
  if (names.empty()) return names;
  return result.string() +
         ": does not match the files beside it, which come from another run or were changed since: " + names +
         "; segment the scene again";
}

void require_of_its_result(const fs::path& file) {
  const fs::path result = file.parent_path() / "result.json";
  std::error_code error;
  if (!fs::is_regular_file(result, error)) return;
  json digests;
  try {
    digests = digests_of(read_result_content(result));
  } catch (const InputError&) {
    return;  // of another program
  }
  const std::string name = file.filename().string();
  if (digests.contains(name) && is_foreign(file.parent_path(), name, digests[name]))
    throw InputError(file.string() +
                     ": does not match the result.json beside it: it comes from another run or was changed since; " +
                     "segment the scene again, or remove that result.json if the image is right");
}

}  // namespace gestalt
