// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/apps/commands/command.h"

#include <map>

namespace gestalt::app {

namespace {

/// Made when the first subcommand registers itself, in whatever order their files are initialised.
std::multimap<int, Subcommand::Add>& registered() {
  static std::multimap<int, Subcommand::Add> all;
  return all;
}

}  // namespace

Subcommand::Subcommand(int place, Add add) { registered().emplace(place, add); }

void Subcommand::add_all(CLI::App& app, Run& run) {
  for (const auto& [place, add] : registered()) add(app, run);
}

}  // namespace gestalt::app
