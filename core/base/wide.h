// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

/// Before a function: it is compiled a second time for processors with wider registers (AVX2), and the right one is
/// taken when the library is loaded. Not with FMA, which rounds otherwise: results are the same to the last bit on
/// every x86-64 processor. With other compilers and under sanitizers, whose start-up is not ready for that choice,
/// there is one compilation.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define GESTALT_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define GESTALT_WIDE
#endif

/// Before a function that such functions call: it becomes a part of each.
#define GESTALT_INLINE __attribute__((always_inline)) inline

namespace gestalt {

constexpr int wide_lanes = 8;

/// Floats on which + - * and comparisons work lane by lane. Passed by reference: how it goes by value differs between
/// the two compilations.
using WideFloats = float __attribute__((vector_size(sizeof(float) * wide_lanes)));

/// x becomes its square root, lane by lane: one instruction in files compiled with -fno-math-errno.
GESTALT_INLINE void take_root(WideFloats& x) {
  for (int i = 0; i < wide_lanes; ++i) x[i] = std::sqrt(x[i]);
}
GESTALT_INLINE void take_root(float& x) { x = std::sqrt(x); }

}  // namespace gestalt
