// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "gestalt/core/pipeline/segmenter.h"
#include "gestalt/core/tracking/tracker.h"

namespace gestalt::app {

/// Poses of a camera by the names of frames, of lines `name tx ty tz qx qy qz qw`; empty lines and those that begin
/// with # are skipped. Throws InputError with the line for anything else, for a name that comes twice, and for a
/// quaternion whose length is not 1 to within a hundredth.
std::map<std::string, Eigen::Isometry3d> read_poses(const std::filesystem::path& file);

/// The tracker of a stream, with the camera's poses where there is a file of them.
class SceneTracker {
 public:
  /// keep: as of TrackerParams; poses: a file, or empty. Throws as read_poses() does.
  SceneTracker(int keep, const std::filesystem::path& poses);

  /// The tracks of the next frame as result.json has them (docs/stream.md). Throws InputError when there are poses, but
  /// none of this frame.
  nlohmann::json update(const std::string& name, const SegmentedFrame& found);

 private:
  Tracker tracker_;
  std::filesystem::path file_;
  std::map<std::string, Eigen::Isometry3d> poses_;
};

}  // namespace gestalt::app
