// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace gestalt::bench {

/// Memory that the process has asked for so far, in all threads, whether it was given back or not.
struct Allocations {
  std::uint64_t count = 0;
  std::uint64_t bytes = 0;
};

/// An executable that links this counts: its malloc and the like are replaced, and with them operator new and
/// what the libraries it uses ask for. Pages that a library takes from the kernel itself (TBB's own tasks) are not
/// seen.
Allocations allocations();

}  // namespace gestalt::bench
