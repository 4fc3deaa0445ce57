// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Components whose factories fail: when they are asked for, or when they are to make something; and a good one.

#include "gestalt/core/plugin/plugin.h"
#include "one_group.h"

namespace {

using SolverFactory = gestalt::Factory<gestalt::Solver>;

const void* throws_at_load() { throw std::runtime_error("no licence for this solver"); }
const void* throws_an_int_at_load() { throw 7; }
const void* null_at_load() { return nullptr; }

const void* throws() {
  static const SolverFactory factory{{}, [](const auto&) -> std::unique_ptr<gestalt::Solver> {
                                       throw std::runtime_error("the table of weights is missing");
                                     }};
  return &factory;
}

const void* throws_an_int() {
  static const SolverFactory factory{{}, [](const auto&) -> std::unique_ptr<gestalt::Solver> { throw 7; }};
  return &factory;
}

const void* gives_null() {
  static const SolverFactory factory{{}, [](const auto&) { return nullptr; }};
  return &factory;
}

}  // namespace

GESTALT_PLUGIN({"solver", "throws_at_load", "1.0.0", "Fails when loaded", &throws_at_load},
               {"solver", "throws_an_int_at_load", "1.0.0", "Fails when loaded", &throws_an_int_at_load},
               {"solver", "null_at_load", "1.0.0", "Has no factory", &null_at_load},
               {"solver", "throws", "1.0.0", "Cannot be made", &throws},
               {"solver", "throws_an_int", "1.0.0", "Cannot be made", &throws_an_int},
               {"solver", "gives_null", "1.0.0", "Makes nothing", &gives_null},
               gestalt::component<gestalt::OneGroup>("one_group", "1.0.0", "Every node in one group"))
