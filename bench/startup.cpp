// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// What passes before the first frame: config, plugins and model in a process that has loaded none of them, and whole
// processes of the gestalt command that do nothing else.

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <system_error>

#include "configs.h"
#include "options.h"
#include "times.h"

namespace {

using namespace gestalt::bench;

/// A plugin is loaded only once in the life of a process, so every run needs one of its own. Throws when it failed.
template <class Work>
void in_child(const Work& work) {
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "cannot start a process");
  if (child == 0) {
    int code = 1;
    try {
      work();
      code = 0;
    } catch (const std::exception& error) {
      std::cerr << "bench_startup: error: " << error.what() << '\n';
    }
    _exit(code);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw std::runtime_error("a process that was timed has failed");
}

/// Milliseconds that the child has measured itself.
double load(const std::filesystem::path& config) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::system_error(errno, std::generic_category(), "cannot make a pipe");
  double time = 0;
  in_child([&] {
    const double spent = milliseconds([&] { const gestalt::Segmenter segmenter(config); });
    if (write(ends[1], &spent, sizeof spent) != sizeof spent) throw std::runtime_error("cannot write to a pipe");
  });
  const bool complete = read(ends[0], &time, sizeof time) == sizeof time;
  close(ends[0]);
  close(ends[1]);
  if (!complete) throw std::runtime_error("cannot read from a pipe");
  return time;
}

void run_silently(const std::vector<const char*>& command) {
  in_child([&] {
    const int null = open("/dev/null", O_WRONLY);
    dup2(null, STDOUT_FILENO);
    std::vector<char*> arguments(command.size() + 1);  // ends with a null
    std::transform(command.begin(), command.end(), arguments.begin(),
                   [](auto* word) { return const_cast<char*>(word); });
    execv(arguments.front(), arguments.data());
    throw std::system_error(errno, std::generic_category(), std::string("cannot run ") + command.front());
  });
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{"Times what passes before the first frame"};
  Options options;
  options.repeats = 20;
  add_config(app, options);
  add_measuring(app, options);
  CLI11_PARSE(app, argc, argv);

  const std::string gestalt = (gestalt::core_library().parent_path().parent_path() / "bin" / "gestalt").string();
  std::vector<double> loading, version, plugins;
  for (int repeat = 0; repeat < options.repeats; ++repeat) {
    loading.push_back(load(options.config));
    version.push_back(milliseconds([&] { run_silently({gestalt.c_str(), "--version"}); }));
    plugins.push_back(milliseconds([&] { run_silently({gestalt.c_str(), "plugins", "list"}); }));
  }
  const nlohmann::ordered_json report = {{"config", options.config.filename().string()},
                                         {"repeats", options.repeats},
                                         {"milliseconds",
                                          {{"config_plugins_model", spread(loading)},
                                           {"gestalt_version", spread(version)},
                                           {"gestalt_plugins_list", spread(plugins)}}}};
  write_report(options, report);
  std::cout << options.repeats << " runs; milliseconds\n" << heading("") << '\n';
  for (const auto& [what, times] : report["milliseconds"].items()) std::cout << row(what, times) << '\n';
  return 0;
} catch (const std::exception& error) {
  std::cerr << "bench_startup: error: " << error.what() << '\n';
  return 1;
}
