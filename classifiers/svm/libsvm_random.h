// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace gestalt {

/// Restarts the random numbers that libsvm draws in this thread; those of other threads, and the C library's rand()
/// of the program, are others. The numbers are those of srand(seed) and rand() of glibc.
void seed_libsvm(unsigned seed);

}  // namespace gestalt
