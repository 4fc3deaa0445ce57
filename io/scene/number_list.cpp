// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "number_list.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"

namespace gestalt {

namespace fs = std::filesystem;

std::vector<double> read_numbers(const fs::path& file) {
  constexpr std::size_t longest = 1 << 16;
  const std::string text = read_bytes(file, longest);
  std::string_view left = text;
  std::vector<double> numbers;
  for (;;) {
    left.remove_prefix(std::min(left.find_first_not_of(" \t\r\n,;[]"), left.size()));
    if (left.empty()) return numbers;
    double value = 0;
    const auto [end, error] = std::from_chars(left.data(), left.data() + left.size(), value);
    if (error != std::errc{} || !std::isfinite(value)) {
      const auto line = 1 + std::count(text.data(), left.data(), '\n');
      throw InputError(file.string() + ":" + std::to_string(line) + ": expected a number, found '" +
                       std::string(left.substr(0, std::min<std::size_t>(left.find_first_of(" \t\r\n"), 20))) + "'");
    }
    left.remove_prefix(std::size_t(end - left.data()));
    numbers.push_back(value);
  }
}

}  // namespace gestalt
