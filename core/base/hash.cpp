// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/base/hash.h"

#include <cstdint>

namespace gestalt {

std::string content_hash(std::string_view bytes) {
  std::uint64_t state = 0xcbf29ce484222325u;
  for (const char c : bytes) state = (state ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  constexpr char digits[] = "0123456789abcdef";
  std::string hexadecimal;
  for (int shift = 60; shift >= 0; shift -= 4) hexadecimal += digits[(state >> shift) & 15];
  return hexadecimal;
}

}  // namespace gestalt
