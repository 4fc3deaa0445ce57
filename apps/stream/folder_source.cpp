// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "folder_source.h"

#include <algorithm>
#include <thread>

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/scene_format.h"
#include "gestalt/io/scene/scene_path.h"

namespace gestalt::app {

namespace fs = std::filesystem;

std::optional<std::vector<fs::path>> FolderSource::next(std::size_t at_most) {
  if (new_.empty()) {
    if (looked_ && !follow_) return std::nullopt;
    if (looked_) std::this_thread::sleep_for(patience);
    look();
  }
  const auto end = new_.begin() + std::ptrdiff_t(std::min(at_most, new_.size()));
  std::vector<fs::path> given(new_.begin(), end);
  new_.erase(new_.begin(), end);
  return given;
}

void FolderSource::look() {
  std::error_code error;
  std::set<fs::path> present;
  fs::directory_iterator entry(folder_, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const fs::path& path = entry->path();
    if (path.filename().string().starts_with('.')) continue;
    if (!seen_.contains(path)) {
      if (!is_scene(path)) continue;
      new_.push_back(path);
    }
    present.insert(path);
  }
  if (error) throw InputError(folder_.string() + ": cannot be listed: " + error.message());
  // With --follow, scenes may come later.
  if (!follow_ && new_.empty())
    throw InputError(folder_.string() + ": holds no scene; give the folder that holds scenes, " +
                     scene_extensions(" or ") + " files, or add --follow to wait for them");
  std::sort(new_.begin(), new_.end(), scene_less);
  seen_ = std::move(present);
  looked_ = true;
}

}  // namespace gestalt::app
