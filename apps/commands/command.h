// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace gestalt::app {

/// What the chosen subcommand does; gives the exit code.
using Run = std::function<int()>;

enum Exit { success = 0, run_failed = 1, wrong_usage = 2, unusable_input = 3 };

/// A subcommand of gestalt: each file of this folder makes one, and so puts it on the command line.
class Subcommand {
 public:
  /// Adds it to the command line; when it is chosen, sets the run.
  using Add = void (*)(CLI::App& app, Run& run);

  /// place: in the list of `gestalt --help`, ascending.
  Subcommand(int place, Add add);

  /// Adds all of them. None of their options and arguments takes an empty text: it is a variable of a script that is
  /// not set, and would silently mean the current folder, or what holds without the option.
  static void add_all(CLI::App& app, Run& run);
};

}  // namespace gestalt::app
