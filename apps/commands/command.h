// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace gestalt::app {

/// What the chosen subcommand does; gives the exit code.
using Run = std::function<int()>;

/// For names of outputs: an empty one would silently mean the current folder.
inline const CLI::Validator not_empty([](std::string& name) { return std::string(name.empty() ? "is empty" : ""); }, "",
                                      "not_empty");

enum Exit { success = 0, run_failed = 1, wrong_usage = 2, unusable_input = 3 };

// Each adds its subcommand to the command line and, when it is chosen, sets run. One file each.
void add_segment(CLI::App& app, Run& run);
void add_stream(CLI::App& app, Run& run);
void add_train(CLI::App& app, Run& run);
void add_evaluate(CLI::App& app, Run& run);
void add_synthesize(CLI::App& app, Run& run);
void add_convert(CLI::App& app, Run& run);
void add_ablate(CLI::App& app, Run& run);
void add_reproduce(CLI::App& app, Run& run);
void add_new_plugin(CLI::App& app, Run& run);
void add_plugins(CLI::App& app, Run& run);
void add_config(CLI::App& app, Run& run);
void add_export(CLI::App& app, Run& run);
void add_inspect(CLI::App& app, Run& run);
void add_info(CLI::App& app, Run& run);
void add_calibrate_noise(CLI::App& app, Run& run);
void add_completion(CLI::App& app, Run& run);

}  // namespace gestalt::app
