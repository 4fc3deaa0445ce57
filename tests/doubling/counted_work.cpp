// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "counted_work.h"

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace {

// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables): functions that the compiler calls have no others
std::uint64_t steps = 0;
std::int64_t bytes_now = 0, most_bytes = 0;
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

}  // namespace

/// Called by the counted sources at each branch.
extern "C" void __sanitizer_cov_trace_pc();  // NOLINT(bugprone-reserved-identifier): the compiler's name
extern "C" void __sanitizer_cov_trace_pc() { ++steps; }

void* operator new(std::size_t size) {
  void* const memory = std::malloc(std::max<std::size_t>(size, 1));
  if (!memory) throw std::bad_alloc();
  bytes_now += std::int64_t(::malloc_usable_size(memory));
  most_bytes = std::max(most_bytes, bytes_now);
  return memory;
}

void operator delete(void* memory) noexcept {
  if (memory) bytes_now -= std::int64_t(::malloc_usable_size(memory));
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }

namespace gestalt::test {

void begin_counting() {
  steps = 0;
  bytes_now = most_bytes = 0;
}

Work end_counting() { return {steps, std::uint64_t(most_bytes)}; }

}  // namespace gestalt::test
