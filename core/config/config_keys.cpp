// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "config_keys.h"

namespace gestalt::config {

Parameter levels_declaration() {
  return {"levels", Parameter::Type::choice,    std::string("structural"), 0, 0, {"structural", both_levels},
          "",       "levels that group patches"};
}

Parameter time_budget_declaration() {
  return {"time_budget",
          Parameter::Type::integer,
          std::int64_t{60'000},
          0,
          86'400'000,
          {},
          "ms",
          "what a frame may take, see on_timeout; 0: no limit"};
}

Parameter on_timeout_declaration() {
  return {"on_timeout",
          Parameter::Type::choice,
          std::string("error"),
          0,
          0,
          {"error", "coarse"},
          "",
          "a frame whose time is over ends with an error, or is decided by the relations that are known then"};
}

Parameter working_resolution_declaration() {
  return {"working_resolution",
          Parameter::Type::integer,
          std::int64_t{0},
          0,
          16'777'216,
          {},
          "pixels",
          "larger frames are segmented at half, a third, ... of their resolution; 0: at all of it"};
}

Parameter minimum_size_declaration(Level level) {
  return {"minimum_size",
          Parameter::Type::integer,
          std::int64_t{level == Level::structural ? 30 : 300},
          1,
          1'000'000,
          {},
          "pixels",
          "smallest patch whose relations are computed, for a focal length of 525"};
}

Parameter negatives_declaration() {
  return {"negatives",
          Parameter::Type::integer,
          std::int64_t{1'000'000},
          1,
          1'000'000,
          {},
          "pairs",
          "largest number of negative pairs of one scene that training uses"};
}

}  // namespace gestalt::config
