// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <iterator>

namespace gestalt::synthesis {

/// Random numbers that are the same on every platform, which the standard library's distributions are not.
/// The generator is splitmix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// A generator whose numbers do not depend on how many this one has given.
  static Random of(std::uint64_t seed, std::uint64_t stream) {
    Random mixed(seed);
    return Random(mixed.bits() ^ (0x9e3779b97f4a7c15u * (stream + 1)));
  }

  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// In [0, 1).
  double uniform() { return double(bits() >> 11) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// In [low, high].
  int integer(int low, int high) { return low + int(bits() % std::uint64_t(high - low + 1)); }
  bool chance(double probability) { return uniform() < probability; }

  template <typename Range>
  const auto& pick(const Range& range) {
    return range[std::size_t(integer(0, int(std::size(range)) - 1))];
  }

  /// Nearly normal with mean 0 and variance 1: the sum of the eight bytes of one number. Bounded by 4.9, fast, and
  /// without the mathematical library, whose last digit differs between machines.
  float normal() {
    const std::uint64_t eight = bits();
    const std::uint64_t pairs = (eight & 0x00ff00ff00ff00ffu) + ((eight >> 8) & 0x00ff00ff00ff00ffu);
    const auto sum = float((pairs * 0x0001000100010001u) >> 48);
    constexpr float mean = 8 * 127.5f, deviation = 209.0214f;  // sqrt(8 (256^2 - 1) / 12)
    return (sum - mean) / deviation;
  }

 private:
  std::uint64_t state_;
};

}  // namespace gestalt::synthesis
