// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/base/digest.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "gestalt/core/base/error.h"

namespace gestalt {

namespace {

std::string hexadecimal(XXH128_hash_t hash) {
  XXH128_canonical_t bytes;
  XXH128_canonicalFromHash(&bytes, hash);
  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : bytes.digest) {
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

}  // namespace

std::string digest(std::string_view bytes) { return hexadecimal(XXH3_128bits(bytes.data(), bytes.size())); }

std::string file_digest(const std::filesystem::path& file) {
  std::error_code error;
  // Opening a pipe would wait for its writer.
  if (!std::filesystem::is_regular_file(file, error))
    throw InputError(file.string() + ": is not a regular file; copy it to one");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  XXH3_state_t state;
  XXH3_INITSTATE(&state);
  XXH3_128bits_reset(&state);
  std::vector<char> block(std::size_t{1} << 18);
  while (in.read(block.data(), std::streamsize(block.size())) || in.gcount() > 0)
    XXH3_128bits_update(&state, block.data(), std::size_t(in.gcount()));
  if (!in.eof()) throw InputError(file.string() + ": cannot be read: " + std::strerror(errno));
  return hexadecimal(XXH3_128bits_digest(&state));
}

}  // namespace gestalt
