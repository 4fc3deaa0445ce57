// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gestalt/io/bag/bag.h"
#include "gestalt/io/scene/converted_scene.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

/// Which topics to take; empty: those that names and types suggest.
struct BagTopics {
  std::string depth, colour;
};

/// A depth image of a bag with what belongs to it.
struct BagFrame {
  std::string name;  ///< the time of depth, "1305031102.160407000"
  MessagePlace depth;
  std::optional<MessagePlace> colour;
};

/// The frames of a recording of ROS. Depth is that of the registered topic, if there is one, else of the only topic of
/// images with "depth" in its name; colour the nearest in time, at most 0.03 s away, of the topic with "color",
/// "colour" or "rgb"; the camera that of the camera_info beside depth. Immutable once made; may be used from many
/// threads at once.
class GESTALT_EXPORT BagFrames {
 public:
  /// Throws InputError naming the file and its topics: for a file without depth, with several such topics, or whose
  /// stamps are all 0.
  explicit BagFrames(std::filesystem::path file, const BagTopics& topics = {});

  const std::vector<BagFrame>& frames() const { return frames_; }

  /// What was chosen and left out, without the file's name; warnings name it, as those of Input do.
  const std::vector<std::string>& notes() const { return notes_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// Throws InputError naming the file and the frame.
  ConvertedScene read(const BagFrame& frame, const ReadOptions& options = {}) const;

 private:
  std::filesystem::path file_;
  std::unique_ptr<Bag> bag_;
  BagTopic depth_, colour_;
  std::optional<CameraFile> camera_;
  std::vector<BagFrame> frames_;
  std::vector<std::string> notes_, warnings_;
};

}  // namespace gestalt
