// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <CLI/CLI.hpp>
#include <iostream>

#include "display.h"
#include "gestalt/core/base/error.h"
#include "window.h"

namespace {

namespace fs = std::filesystem;

int run(int argc, char** argv) {
  CLI::App app{"Shows results of gestalt segment in PCL's viewer", "gestalt-view"};
  std::vector<fs::path> results;
  fs::path screenshot;
  app.set_version_flag("--version", "gestalt-view " GESTALT_VERSION);
  app.add_option("RESULT", results, "Folders that gestalt segment --also pcd has written")->required();
  app.add_option("--screenshot", screenshot, "Write a picture of the first one, and end")->type_name("PNG");
  app.footer(
      "Example: gestalt segment examples/demo_scene --output out --also pcd\n"
      "         gestalt-view out/demo_scene");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const gestalt::view::DisplayConnection display;
  if (screenshot.empty())
    gestalt::view::show(results);
  else
    gestalt::view::take_picture(results[0], screenshot);
  return 0;
}

int report(const std::exception& error, int code) {
  std::cerr << "gestalt-view: error: " << error.what() << '\n';
  return code;
}

}  // namespace

int main(int argc, char** argv) try { return run(argc, argv); } catch (const gestalt::InputError& error) {
  return report(error, 3);
} catch (const std::exception& error) {
  return report(error, 1);
}
