// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "run_gestalt.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <stdexcept>
#include <thread>

#include "gestalt/tests/environment/temporary_folder.h"

namespace gestalt::test {

namespace fs = std::filesystem;

namespace {

void limit(int resource, std::size_t value) {
  const rlimit both{value, value};
  if (value > 0 && ::setrlimit(resource, &both) != 0) ::_exit(127);
}

/// Becomes the command. Runs between fork and exec.
[[noreturn]] void become(char* const* arguments, char* const* variables, const char* folder, const char* in,
                         const char* out, const char* err, const Surroundings& surroundings) {
  if (*in) {
    const int in_file = ::open(in, O_RDONLY);
    if (in_file < 0 || ::dup2(in_file, STDIN_FILENO) < 0) ::_exit(127);
  }
  const int out_file = ::open(out, O_WRONLY | O_CREAT, 0600), err_file = ::open(err, O_WRONLY | O_CREAT, 0600);
  if (out_file < 0 || err_file < 0 || ::dup2(out_file, STDOUT_FILENO) < 0 || ::dup2(err_file, STDERR_FILENO) < 0)
    ::_exit(127);
  if (*folder && ::chdir(folder) != 0) ::_exit(127);
  limit(RLIMIT_AS, surroundings.memory);
  limit(RLIMIT_FSIZE, surroundings.file_size);
  ::signal(SIGINT, SIG_DFL);  // a shell's background jobs ignore it
  ::execve(arguments[0], arguments, variables);
  ::_exit(127);
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  result.reserve(texts.size() + 1);
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

void interrupt(pid_t child, const fs::path& file, int signal) {
  siginfo_t ended{};
  while (!fs::exists(file)) {
    if (::waitid(P_PID, id_t(child), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 || ended.si_pid == child) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ::kill(child, signal);
}

}  // namespace

Outcome run_gestalt(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
  const TemporaryFolder streams;
  std::vector<std::string> words{GESTALT_COMMAND};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = surroundings.variables;
  for (char** variable = environ; *variable; ++variable) variables.emplace_back(*variable);
  const std::vector<char*> argv = pointers(words), envp = pointers(variables);
  const std::string folder = surroundings.folder, in = surroundings.standard_input, err = streams.path() / "err",
                    out = surroundings.standard_output.empty() ? streams.path() / "out" : surroundings.standard_output;

  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("the command cannot be started");
  if (child == 0) become(argv.data(), envp.data(), folder.c_str(), in.c_str(), out.c_str(), err.c_str(), surroundings);
  if (!surroundings.interrupt_after.empty()) interrupt(child, surroundings.interrupt_after, surroundings.signal);
  int status = 0;
  ::waitpid(child, &status, 0);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, surroundings.standard_output.empty() ? content(out) : "", content(err)};
}

void expect_success(const Outcome& outcome) {
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
}

void expect_refused(const Outcome& outcome, int code, const std::vector<std::string>& words) {
  EXPECT_EQ(outcome.code, code) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(occurrences("gestalt: error: ", outcome.err), 1) << outcome.err;
  EXPECT_TRUE(outcome.err.starts_with("gestalt: error: ")) << outcome.err;
  EXPECT_TRUE(outcome.err.ends_with('\n')) << outcome.err;
  for (const std::string& word : words)
    EXPECT_EQ(occurrences(word, outcome.err) > 0, true) << word << "\nnot in\n" << outcome.err;
}

int occurrences(const std::string& part, const std::string& text) {
  int count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

std::vector<std::string> files_below(const fs::path& folder) {
  std::vector<std::string> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), folder));
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace gestalt::test
