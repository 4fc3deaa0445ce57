// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <exception>
#include <iostream>

#include "command.h"
#include "gestalt/error.h"
#include "gestalt/registry.h"

namespace {

int report(const std::exception& error, int code) {
  std::cerr << "gestalt: error: " << error.what() << '\n';
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace gestalt::app;
  CLI::App app{"Segments unknown objects in RGB-D frames of cluttered scenes by learned perceptual grouping",
               "gestalt"};
  app.require_subcommand(1);
  app.set_version_flag("--version", "gestalt " GESTALT_VERSION " [" + gestalt::build_fingerprint() + "]");
  app.footer("Exit codes: 0 success, 1 the run failed, 2 wrong usage or config, 3 unusable input.");
  Run run;
  add_segment(app, run);
  add_train(app, run);
  add_evaluate(app, run);
  add_synthesize(app, run);
  add_plugins(app, run);
  add_config(app, run);
  add_info(app, run);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? success : wrong_usage;
  }
  try {
    return run();
  } catch (const gestalt::ConfigError& error) {
    return report(error, wrong_usage);
  } catch (const gestalt::PluginError& error) {
    return report(error, wrong_usage);
  } catch (const gestalt::ModelError& error) {
    return report(error, wrong_usage);
  } catch (const gestalt::InputError& error) {
    return report(error, unusable_input);
  } catch (const std::exception& error) {
    return report(error, run_failed);
  }
}
