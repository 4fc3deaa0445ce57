// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace gestalt::test {

using Texts = std::vector<std::string>;

/// One list after the other.
inline Texts joined(Texts first, const Texts& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// How a run of the command ended.
struct Outcome {
  int code = 0;  ///< exit code; of a signal 128 + its number
  std::string out;
  std::string err;
};

/// Where the command runs.
struct Surroundings {
  std::filesystem::path folder = {};           ///< current folder; empty: that of the test
  std::vector<std::string> variables = {};     ///< NAME=value, beside those of the test
  std::filesystem::path standard_input = {};   ///< file or device to read from; empty: that of the test
  std::filesystem::path standard_output = {};  ///< file or device to write to; empty: kept in Outcome::out
  std::filesystem::path interrupt_after = {};  ///< the signal is sent once this file is there; empty: never
  int signal = SIGINT;
  std::size_t memory = 0;     ///< bytes of address space; 0: no limit
  std::size_t file_size = 0;  ///< bytes that a written file may have, as on a full disk; 0: no limit
};

/// Runs `gestalt arguments...` to its end.
Outcome run_gestalt(const Texts& arguments, const Surroundings& surroundings = {});

/// Expects success and nothing on stderr.
void expect_success(const Outcome& outcome);

/// Expects the exit code, nothing on stdout and one message on stderr, which holds all of the words.
void expect_refused(const Outcome& outcome, int code, const Texts& words);

/// Number of times that a part occurs in a text.
int occurrences(const std::string& part, const std::string& text);

/// Every regular file below a folder, relative to it, sorted; empty when there is no such folder.
std::vector<std::string> files_below(const std::filesystem::path& folder);

}  // namespace gestalt::test
