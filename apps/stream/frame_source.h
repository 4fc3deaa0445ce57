// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace gestalt::app {

/// Where frames come from.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// How long next() waits at most.
  static constexpr std::chrono::milliseconds patience{20};

  /// The frames that have come since the last call, oldest first; those beyond at_most are kept for the next one.
  /// Waits a moment for one. Nothing: no more will come. Throws InputError when the source cannot be read.
  virtual std::optional<std::vector<std::filesystem::path>> next(std::size_t at_most) = 0;
};

/// A folder of scenes: first those in it in natural order, then, with follow, those that are added, for ever. Or a
/// file, a named pipe or standard input ("-") with one path a line, those in a file from the file's folder. Throws
/// InputError for anything else, ConfigError when the source to follow is not a folder.
std::unique_ptr<FrameSource> open_source(const std::filesystem::path& source, bool follow);

}  // namespace gestalt::app
