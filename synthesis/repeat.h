// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace gestalt::synthesis {

/// Calls add until it has succeeded count times; false after too many failures.
template <typename Add>
bool repeat(int count, Add&& add) {
  int failures = 0;
  for (int done = 0; done < count;) {
    if (add()) {
      ++done;
    } else if (++failures > 5 + 2 * count) {
      return false;
    }
  }
  return true;
}

/// Calls add until it has succeeded count times, or failed too often; false when it has then succeeded fewer than least
/// times.
template <typename Add>
bool repeat_as_fits(int count, int least, Add&& add) {
  int done = 0;
  for (int failures = 0; done < count && failures < 6 + count;) ++(add() ? done : failures);
  return done >= least;
}

}  // namespace gestalt::synthesis
