// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace gestalt::app {

/// From here on, a signal that ends the process (a segmentation fault, an abort, ...) first says on stderr which
/// component was running: code of others cannot be contained, but it can be named. Handlers that are there, such as a
/// sanitizer's, stay.
void report_crashes();

/// While it lives, exit() and quick_exit() are a failure that is reported in the same way: a component that calls them
/// would end the run with its results not written, and the exit code of its choice. What calls _exit() is not seen.
/// One at a time.
class Unfinished {
 public:
  Unfinished();
  ~Unfinished();
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
};

}  // namespace gestalt::app
