// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gestalt/core/base/thread_limit.h"
#include "gestalt/core/config/config.h"

namespace gestalt::bench {

/// Command-line options of every program that measures whole frames.
struct Options {
  std::vector<std::filesystem::path> scenes;
  std::filesystem::path config = default_config();
  int synthetic = 10;  ///< number of synthetic frames where no scene is given
  int repeats = 3;     ///< runs of each frame
  int threads = 2;
  bool quick = false;
  std::filesystem::path json;  ///< empty: write none
};

void add_scenes(CLI::App& app, Options& options);
void add_config(CLI::App& app, Options& options);
void add_threads(CLI::App& app, Options& options);

/// --repeats, --quick and --json. Quick means one run and one synthetic frame: it shows that a program works, not how
/// fast.
void add_measuring(CLI::App& app, Options& options);

/// "frames, runs of each, threads", the line above a table of milliseconds.
std::string caption(const Options& options, std::size_t frames);

/// Writes the report where --json asks for it. Throws OutputError.
void write_report(const Options& options, const nlohmann::ordered_json& report);

}  // namespace gestalt::bench
