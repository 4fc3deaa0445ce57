// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace gestalt::view {

/// The display of $DISPLAY. Hold it while windows are opened: an X server may reset itself when its last client goes.
class DisplayConnection {
 public:
  /// Throws OutputError where there is none, as VTK would end the process.
  DisplayConnection();
  ~DisplayConnection();
  DisplayConnection(const DisplayConnection&) = delete;
  DisplayConnection& operator=(const DisplayConnection&) = delete;

 private:
  void* display_;
};

}  // namespace gestalt::view
