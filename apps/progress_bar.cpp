// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "progress_bar.h"

#include <unistd.h>

#include <iostream>
#include <string_view>

namespace gestalt::app {

ProgressBar::ProgressBar(std::size_t total) : total_(total), shown_(total > 1 && ::isatty(STDERR_FILENO)) {}

void ProgressBar::show(std::size_t done, const std::string& what) const {
  if (!shown_) return;
  constexpr std::size_t width = 30;
  const std::size_t full = width * done / total_;
  clear();
  std::cerr << '[' << std::string(full, '#') << std::string(width - full, ' ') << "] " << done << '/' << total_ << ' '
            << what << std::flush;
}

void ProgressBar::clear() const {
  constexpr std::string_view erase = "\r\033[K";  // not through a stream, which keeps such from the terminal
  if (shown_ && ::write(STDERR_FILENO, erase.data(), erase.size()) < 0) return;
}

}  // namespace gestalt::app
