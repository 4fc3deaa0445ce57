// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "next_step.h"

#include <unistd.h>

#include <iostream>
#include <string_view>

namespace gestalt::app {

namespace {

std::string as_shell_word(const std::string& word) {
  constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./=:,+@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

}  // namespace

void suggest_next(const std::string& purpose, const std::vector<std::string>& words) {
  if (!::isatty(STDERR_FILENO)) return;
  std::cout << std::flush;
  std::cerr << purpose << ": gestalt";
  for (const std::string& word : words) std::cerr << ' ' << as_shell_word(word);
  std::cerr << '\n';
}

}  // namespace gestalt::app
