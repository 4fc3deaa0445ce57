// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace gestalt::app {

/// The program gestalt-view: one of its own, as the command does not load VTK.
class Viewer {
 public:
  /// Throws OutputError where it is not installed or $DISPLAY names no display.
  Viewer();

  /// Shows results that have their labelled.pcd until the window is closed. Gives the program's exit code.
  int show(const std::vector<std::filesystem::path>& results) const;

 private:
  std::filesystem::path program_;
};

}  // namespace gestalt::app
