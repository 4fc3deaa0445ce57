// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/base/deadline.h"

#include <string>

#include "gestalt/core/base/error.h"

namespace gestalt {

Deadline Deadline::within(int budget, double spent) {
  Deadline deadline;
  deadline.budget_ = budget;
  if (budget > 0)
    deadline.begin_ =
        Clock::now() - std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double, std::milli>(spent));
  return deadline;
}

void Deadline::require(std::string_view at_work) const {
  if (budget_ == 0) return;
  const auto spent = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begin_).count();
  if (spent < budget_) return;
  throw TimeError("the frame exceeded its time_budget of " + std::to_string(budget_) + " ms: " + std::to_string(spent) +
                  " ms had passed while " + std::string(at_work) +
                  " was running; raise it, for example with --set time_budget=" +
                  std::to_string(2 * std::int64_t{budget_}) + " (0: no limit), or remove slow components");
}

}  // namespace gestalt
