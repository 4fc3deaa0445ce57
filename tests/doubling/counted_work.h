// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace gestalt::test {

/// What something has cost this process: the same in every run, on any machine.
struct Work {
  std::uint64_t steps = 0;  ///< branches taken in the counted sources, templates of libraries included
  std::uint64_t bytes = 0;  ///< of memory that was asked for at one time, at most
};

/// That of a function. One thread at a time.
template <class Function>
Work counted(const Function& function);

void begin_counting();
Work end_counting();

template <class Function>
Work counted(const Function& function) {
  begin_counting();
  function();
  return end_counting();
}

}  // namespace gestalt::test
