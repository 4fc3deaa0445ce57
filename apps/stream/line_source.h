// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "frame_source.h"

namespace gestalt::app {

/// Paths from a file or pipe, one a line; empty lines are left out. The byte order mark and the carriage returns of a
/// list from Windows are dropped where nothing has a name with them. Reads only as far ahead as one block of a file.
class LineSource : public FrameSource {
 public:
  /// file: a descriptor, closed at the end. name: for errors. folder: where relative paths begin.
  LineSource(int file, std::string name, std::filesystem::path folder)
      : file_(file), name_(std::move(name)), folder_(std::move(folder)) {}
  ~LineSource() override;
  LineSource(const LineSource&) = delete;
  LineSource& operator=(const LineSource&) = delete;

  std::optional<std::vector<std::filesystem::path>> next(std::size_t at_most) override;

 private:
  std::filesystem::path path_of(const std::string& line) const;
  bool readable(std::chrono::milliseconds wait) const;
  void read();
  void split(std::vector<std::filesystem::path>& paths, std::size_t at_most);

  const int file_;
  const std::string name_;
  const std::filesystem::path folder_;
  std::string unread_;  ///< read from the file, not given yet
  std::size_t lines_ = 0;
  bool ended_ = false;
};

}  // namespace gestalt::app
