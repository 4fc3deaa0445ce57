// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// libsvm draws its folds from rand(), which the whole process shares: a training in another plugin, or a host that
// draws, would change a model. The linker's --wrap leads libsvm to a generator of each thread instead.

#include "libsvm_random.h"

#include <array>
#include <cstdint>
#include <cstdlib>

namespace gestalt {

namespace {

/// glibc's generator, in the size that rand() has.
class Generator {
 public:
  Generator() { seed(1); }

  void seed(unsigned seed) {
    data_ = {};
    initstate_r(seed, state_.data(), state_.size(), &data_);
  }

  int draw() {
    std::int32_t value = 0;
    random_r(&data_, &value);
    return value;
  }

 private:
  std::array<char, 128> state_{};
  random_data data_{};
};

thread_local Generator generator;

}  // namespace

void seed_libsvm(unsigned seed) { generator.seed(seed); }

extern "C" {
// NOLINTNEXTLINE(bugprone-reserved-identifier): the linker's name
[[gnu::visibility("hidden")]] int __wrap_rand() { return generator.draw(); }
}

}  // namespace gestalt
