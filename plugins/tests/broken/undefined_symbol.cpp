// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Calls a function that no library has. Bound lazily, it would load and then end the process at the first call.

#include "gestalt/core/plugin/plugin.h"

extern "C" int gestalt_function_that_nobody_defines();

namespace {

class Calling final : public gestalt::Solver {
 public:
  struct Params {};
  static const gestalt::Parameters<Params>& parameters() {
    static const gestalt::Parameters<Params> none;
    return none;
  }

  explicit Calling(const Params&) {}
  std::vector<int> solve(const gestalt::Graph&) const override { return {gestalt_function_that_nobody_defines()}; }
};

}  // namespace

GESTALT_PLUGIN(gestalt::component<Calling>("calling", "1.0.0", "Calls what is not there"))
