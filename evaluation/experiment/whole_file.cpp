// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "whole_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "gestalt/core/base/error.h"

namespace gestalt {

std::string whole_file(const std::filesystem::path& file) {
  std::error_code error;
  const auto type = std::filesystem::status(file, error).type();
  if (type == std::filesystem::file_type::fifo || type == std::filesystem::file_type::character)
    throw InputError(file.string() + ": cannot be read: it has no end; copy it to a file");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad() || std::filesystem::is_directory(file))
    throw InputError(file.string() + ": cannot be read: " + (errno ? std::strerror(errno) : "it is no file"));
  return bytes;
}

}  // namespace gestalt
