// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "tolerances.h"

namespace gestalt {

/// The tolerances of the depths that were asked for last. A sensor tells depth in steps, so that a frame of 300,000
/// pixels has a few thousand depths. For one thread; keeps a reference.
class ToleranceMemory {
 public:
  explicit ToleranceMemory(const Tolerances& tolerances) : tolerances_(tolerances), entries_(1 << bits) {}

  /// Tolerances::distance(z), to the last bit.
  float distance(float z) { return at(z).distance; }

  /// Tolerances::cosine(z), to the last bit.
  float cosine(float z) { return at(z).cosine; }

 private:
  struct Entry {
    float z = 0;  // no pixel's depth
    float distance, cosine;
  };
  static constexpr int bits = 12;

  const Entry& at(float z) {
    Entry& entry = entries_[std::bit_cast<std::uint32_t>(z) * 0x9E3779B1u >> (32 - bits)];
    if (entry.z != z) entry = {z, tolerances_.distance(z), tolerances_.cosine(z)};
    return entry;
  }

  const Tolerances& tolerances_;
  std::vector<Entry> entries_;
};

}  // namespace gestalt
