// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "built_with.h"
#include "crash_report.h"
#include "gestalt/apps/commands/command.h"
#include "gestalt/core/base/error.h"
#include "plain_text.h"
#include "usage.h"

namespace {

/// The reader of standard output has closed it, as `head` does, which is not a failure.
bool reader_has_gone() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0;
}

/// What was printed is lost when standard output is on a full disk: then the run has failed.
int printed(int code) {
  if (std::cout.flush() || reader_has_gone()) return code;
  std::cerr << "gestalt: error: standard output cannot be written; check free space\n";
  return code == gestalt::app::success ? gestalt::app::run_failed : code;
}

int report(const std::exception& error, int code) {
  std::cerr << "gestalt: error: " << error.what() << '\n';
  return code;
}

int run_command(int argc, char** argv) {
  // A reader that has gone, or a limit on the size of files, is a failed write, not a sudden death.
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
  using namespace gestalt::app;
  report_crashes();
  CLI::App app{"Segments unknown objects in RGB-D frames of cluttered scenes by learned perceptual grouping",
               "gestalt"};
  app.require_subcommand(1);
  app.set_version_flag("-v,--version", built_with, "Print this version and those of what it was built with");
  app.footer(
      "Example: gestalt segment examples/demo_scene --output out\n"
      "Exit codes: 0 success, 1 the run failed, 2 wrong usage or config, 3 unusable input.");
  Run run;
  Subcommand::add_all(app, run);
  try {
    std::vector<std::string> words = command_line(argc, argv);
    std::reverse(words.begin(), words.end());  // as CLI11 takes them
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    return printed(report_usage(app, error));
  }
  try {
    std::error_code error;
    if (std::filesystem::current_path(error).empty())
      throw gestalt::ConfigError("the current folder no longer exists; change to another one");
    const Unfinished unfinished;
    return printed(run());
  } catch (const gestalt::ConfigError& error) {
    return report(error, wrong_usage);
  } catch (const gestalt::PluginError& error) {
    return report(error, wrong_usage);
  } catch (const gestalt::ModelError& error) {
    return report(error, wrong_usage);
  } catch (const gestalt::InputError& error) {
    return report(error, unusable_input);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const gestalt::app::PlainTerminal terminal;
  try {
    return run_command(argc, argv);
  } catch (const std::bad_alloc&) {
    const gestalt::Error error("out of memory; raise the memory limit of this process, or use a smaller input");
    return report(error, gestalt::app::run_failed);
  } catch (const std::exception& error) {
    return report(error, gestalt::app::run_failed);
  }
}
