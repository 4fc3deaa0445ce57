// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "allocations.h"

#include <atomic>
#include <cerrno>
#include <cstddef>

namespace {

std::atomic<std::uint64_t> allocation_count{0}, allocated_bytes{0};

void note(std::size_t size) {
  allocation_count.fetch_add(1, std::memory_order_relaxed);
  allocated_bytes.fetch_add(size, std::memory_order_relaxed);
}

}  // namespace

// glibc's own, under the names that stay when the usual ones are replaced.
extern "C" {
void* __libc_malloc(std::size_t size);                           // NOLINT(bugprone-reserved-identifier)
void* __libc_calloc(std::size_t count, std::size_t size);        // NOLINT(bugprone-reserved-identifier)
void* __libc_realloc(void* block, std::size_t size);             // NOLINT(bugprone-reserved-identifier)
void* __libc_memalign(std::size_t alignment, std::size_t size);  // NOLINT(bugprone-reserved-identifier)

#define GESTALT_REPLACES [[gnu::visibility("default")]]

GESTALT_REPLACES void* malloc(std::size_t size) noexcept {
  note(size);
  return __libc_malloc(size);
}

GESTALT_REPLACES void* calloc(std::size_t count, std::size_t size) noexcept {
  note(count * size);
  return __libc_calloc(count, size);
}

GESTALT_REPLACES void* realloc(void* block, std::size_t size) noexcept {
  note(size);
  return __libc_realloc(block, size);
}

GESTALT_REPLACES void* memalign(std::size_t alignment, std::size_t size) noexcept {
  note(size);
  return __libc_memalign(alignment, size);
}

GESTALT_REPLACES void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return memalign(alignment, size);
}

GESTALT_REPLACES int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
  void* const made = memalign(alignment, size);
  if (!made) return ENOMEM;
  *block = made;
  return 0;
}
}

namespace gestalt::bench {

Allocations allocations() { return {allocation_count.load(), allocated_bytes.load()}; }

}  // namespace gestalt::bench
