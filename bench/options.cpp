// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "options.h"

#include "gestalt/core/base/output_file.h"

namespace gestalt::bench {

void add_scenes(CLI::App& app, Options& options) {
  app.add_option("scenes", options.scenes, "Scenes or folders of scenes (default: synthetic crowded scenes)");
}

void add_config(CLI::App& app, Options& options) {
  app.add_option("--config", options.config, "Config file (default: the installed default.yaml)")->type_name("FILE");
}

void add_threads(CLI::App& app, Options& options) {
  app.add_option("--threads", options.threads, "Threads")->check(CLI::Range(1, 1024))->capture_default_str();
}

void add_measuring(CLI::App& app, Options& options) {
  app.add_option("--repeats", options.repeats, "Runs of each")->check(CLI::Range(1, 1000))->capture_default_str();
  app.add_option("--json", options.json, "Write the figures to this file")->type_name("FILE");
  app.add_flag_callback(
      "--quick", [&options] { options.quick = true, options.synthetic = options.repeats = 1; },
      "One run of each, one synthetic frame: whether it works, not how fast");
}

std::string caption(const Options& options, std::size_t frames) {
  return std::to_string(frames) + " frames, " + std::to_string(options.repeats) + " runs each, " +
         std::to_string(options.threads) + " threads; milliseconds\n";
}

void write_report(const Options& options, const nlohmann::ordered_json& report) {
  if (!options.json.empty()) write_file(options.json, report.dump(1) + '\n');
}

}  // namespace gestalt::bench
