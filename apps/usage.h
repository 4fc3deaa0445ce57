// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace gestalt::app {

/// The words after the program's name, with `help`, `help COMMAND...` and `version` as the options that they stand for.
std::vector<std::string> command_line(int argc, char** argv);

/// Reports an error of the command line on stderr, with what was probably meant and where help is; of a command that
/// lacks its subcommand, the help itself. Prints help and version on stdout. Returns the exit code.
int report_usage(const CLI::App& app, const CLI::ParseError& error);

}  // namespace gestalt::app
