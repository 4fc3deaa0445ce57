// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "usage.h"

#include <algorithm>
#include <iostream>

#include "gestalt/apps/commands/command.h"
#include "gestalt/core/base/suggest.h"

namespace gestalt::app {

namespace {

/// The subcommand that was typed last: of `gestalt config print --confg` print.
const CLI::App& innermost(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().back();
  return *command;
}

std::string name_of(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return (parent == nullptr ? "" : name_of(*parent) + " ") + command.get_name();
}

std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> subcommands_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* subcommand : command.get_subcommands({})) names.push_back(subcommand->get_name());
  return names;
}

/// What was typed and is none of a command's options, arguments or subcommands.
std::string unexpected(const CLI::App& app, const CLI::App& command) {
  const std::vector<std::string> words = app.remaining(true);
  const auto option =
      std::find_if(words.begin(), words.end(), [](const std::string& word) { return word.starts_with('-'); });
  if (option == words.end()) {
    const std::string word = words.empty() ? "" : words.front();
    const std::vector<std::string> subcommands = subcommands_of(command);
    return (subcommands.empty() ? "unexpected argument '" : "unknown subcommand '") + word + "'" +
           did_you_mean(word, subcommands);
  }
  const std::string name = option->substr(0, option->find('='));
  return "unknown option '" + name + "'" + did_you_mean(name, options_of(command));
}

}  // namespace

std::vector<std::string> command_line(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (words.empty()) return words;
  if (words[0] == "version") words[0] = "--version";
  if (words[0] == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  return words;
}

int report_usage(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return app.exit(error);
  const CLI::App& command = innermost(app);
  const bool requires_more = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  // A mistyped option or subcommand leaves the right one missing, of which alone CLI11 tells.
  const bool typed =
      dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr || (requires_more && app.remaining_size(true) > 0);
  const bool lacks_subcommand = requires_more && command.get_require_subcommand_min() > 0;
  if (lacks_subcommand && !typed) std::cerr << command.help() << '\n';  // the first thing that people type
  std::cerr << name_of(command) << ": error: "
            << (typed              ? unexpected(app, command)
                : lacks_subcommand ? "a subcommand is required"
                                   : error.what())
            << "\nSee " << name_of(command) << " --help.\n";
  return wrong_usage;
}

}  // namespace gestalt::app
