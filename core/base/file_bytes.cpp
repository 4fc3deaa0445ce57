// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/base/file_bytes.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include "gestalt/core/base/error.h"

namespace gestalt {

std::string read_bytes(const std::filesystem::path& file, std::uintmax_t most) {
  const auto fail = [&](const std::string& what) { throw InputError(file.string() + ": " + what); };
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) fail("does not exist; check the path");
  if (error) fail("cannot be read: " + error.message());
  if (status.type() == std::filesystem::file_type::directory) fail("is a folder; a file is needed here");
  if (status.type() != std::filesystem::file_type::regular) fail("is not a regular file; copy it to one");

  errno = 0;
  std::ifstream in(file, std::ios::binary);
  const auto size = std::filesystem::file_size(file, error);
  if (!in || error) fail("cannot be read: " + (error ? error.message() : std::string(std::strerror(errno))));
  if (size == 0) fail("is empty; write or copy it again");
  if (size > most)
    fail("has " + std::to_string(size) + " bytes, more than the limit of " + std::to_string(most) + "; check the path");
  std::string bytes(size, '\0');
  if (!in.read(bytes.data(), std::streamsize(size))) fail("cannot be read completely; it may be changing on disk");
  return bytes;
}

}  // namespace gestalt
