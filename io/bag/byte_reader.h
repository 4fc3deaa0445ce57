// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "gestalt/core/base/error.h"

namespace gestalt {

/// Reads numbers and texts, little-endian, from bytes that may be untrusted. Throws InputError, without the file's
/// name, where the bytes end too early.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  bool ended() const { return place_ == bytes_.size(); }
  std::size_t place() const { return place_; }
  std::size_t left() const { return bytes_.size() - place_; }

  std::string_view bytes(std::uint64_t count) {
    if (count > left())
      throw InputError("a length of " + std::to_string(count) + " bytes reaches beyond the end, where " +
                       std::to_string(left()) + " are left");
    const std::string_view part = bytes_.substr(place_, std::size_t(count));
    place_ += std::size_t(count);
    return part;
  }

  template <class Number>
  Number number() {
    Number value;
    std::memcpy(&value, bytes(sizeof value).data(), sizeof value);
    return value;
  }

  /// Of 32-bit length.
  std::string_view text() { return bytes(number<std::uint32_t>()); }

  /// Leaves out what is there so that the place from begin on is a multiple of size.
  void align(std::size_t size, std::size_t begin) {
    const std::size_t beyond = (place_ - begin) % size;
    if (beyond != 0) bytes(size - beyond);
  }

 private:
  std::string_view bytes_;
  std::size_t place_ = 0;
};

}  // namespace gestalt
