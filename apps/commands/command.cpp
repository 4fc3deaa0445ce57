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

const CLI::Validator not_empty([](std::string& text) { return std::string(text.empty() ? "is empty" : ""); }, "",
                               "not_empty");

void refuse_empty_values(CLI::App& command) {
  for (CLI::Option* option : command.get_options())
    if (option->get_items_expected_max() > 0) option->check(not_empty);
  for (CLI::App* subcommand : command.get_subcommands({})) refuse_empty_values(*subcommand);
}

}  // namespace

Subcommand::Subcommand(int place, Add add) { registered().emplace(place, add); }

void Subcommand::add_all(CLI::App& app, Run& run) {
  for (const auto& [place, add] : registered()) add(app, run);
  refuse_empty_values(app);
}

}  // namespace gestalt::app
