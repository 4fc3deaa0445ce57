// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "gestalt/core/base/error.h"

namespace gestalt::fuzz {

/// A folder of this process for the files that are read, in memory where the system has a place for that; gone at its
/// end.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  /// Writes a file, in folders that are made, and gives its path.
  std::filesystem::path write(const std::string& name, std::string_view bytes) const;

 private:
  std::filesystem::path folder_;
};

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// The input as several files: what lies between bytes of 0xff, which are in no text. The last one takes the rest.
std::vector<std::string_view> parts_of(std::string_view input, std::size_t count);

/// What is wrong with an input is reported by an Error; anything else that is thrown ends the process, as a find.
template <class Read>
int expect_result_or_error(const Read& read) {
  try {
    read();
  } catch (const Error&) {
  }
  return 0;
}

}  // namespace gestalt::fuzz
