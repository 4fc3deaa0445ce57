// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>

namespace gestalt::app {

/// While it lives, SIGINT and SIGTERM ask for an orderly end instead of ending the process. The second one of a kind
/// does end it, so that nobody has to wait for a frame that hangs. One at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// Whether a signal has come. From any thread.
  bool requested() const { return signal() != 0; }

  /// The signal that has come; 0: none.
  int signal() const;

 private:
  struct sigaction interrupt_before_ {};
  struct sigaction terminate_before_ {};
};

}  // namespace gestalt::app
