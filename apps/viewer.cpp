// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "viewer.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "gestalt/apps/commands/command.h"
#include "gestalt/core/base/error.h"

namespace gestalt::app {

Viewer::Viewer() : program_(std::filesystem::read_symlink("/proc/self/exe").replace_filename("gestalt-view")) {
  std::error_code ignored;
  if (!std::filesystem::exists(program_, ignored))
    throw OutputError("--view needs " + program_.string() +
                      ", which is not installed; install the package gestalt-view, or use gestalt inspect");
  const char* display = std::getenv("DISPLAY");
  if (display == nullptr || *display == '\0')
    throw OutputError("--view needs a display, but $DISPLAY is not set; gestalt inspect writes a page for a browser");
}

int Viewer::show(const std::vector<std::filesystem::path>& results) const {
  std::vector<std::string> words{program_.string()};
  for (const std::filesystem::path& result : results) words.push_back(result.string());
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t process = 0;
  if (const int error = posix_spawn(&process, program_.c_str(), nullptr, nullptr, arguments.data(), environ))
    throw OutputError(program_.string() + ": cannot be started: " + std::strerror(error));
  int status = 0;
  while (waitpid(process, &status, 0) < 0)
    if (errno != EINTR) throw OutputError(program_.string() + ": was lost: " + std::strerror(errno));
  return WIFEXITED(status) ? WEXITSTATUS(status) : run_failed;
}

}  // namespace gestalt::app
