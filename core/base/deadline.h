// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string_view>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// When the time that a frame may take is over: that of the config's `time_budget`, or never.
class GESTALT_EXPORT Deadline {
 public:
  /// Never.
  Deadline() = default;

  /// budget milliseconds from now, of which spent are gone already; never where the budget is 0.
  static Deadline within(int budget, double spent);

  /// Throws TimeError once the time is over, with what was running ("solver 'alpha'"). For every round of a loop that
  /// may be long: costs a look at the clock.
  void require(std::string_view at_work) const;

 private:
  using Clock = std::chrono::steady_clock;

  int budget_ = 0;  ///< milliseconds; 0: no end
  Clock::time_point begin_{};
};

}  // namespace gestalt
