// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <set>

#include "frame_source.h"

namespace gestalt::app {

/// The scenes of a folder. A name that begins with a dot is not there yet: what is being written has such a name until
/// it is complete. Looks at the folder's names again and again, which works on every file system; a name that has been
/// there all the time is not looked at twice.
class FolderSource : public FrameSource {
 public:
  FolderSource(std::filesystem::path folder, bool follow) : folder_(std::move(folder)), follow_(follow) {}

  std::optional<std::vector<std::filesystem::path>> next(std::size_t at_most) override;

 private:
  void look();

  const std::filesystem::path folder_;
  const bool follow_;
  bool looked_ = false;
  std::set<std::filesystem::path> seen_;
  std::deque<std::filesystem::path> new_;  ///< seen but not given yet
};

}  // namespace gestalt::app
