// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace gestalt::app {

/// One line on stderr that is drawn over itself. Nothing for a single step, or where stderr is not a terminal.
class ProgressBar {
 public:
  explicit ProgressBar(std::size_t total);
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::size_t done, const std::string& what) const;
  void clear() const;

 private:
  std::size_t total_;
  bool shown_;
};

}  // namespace gestalt::app
