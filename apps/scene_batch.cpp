// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scene_batch.h"

#include <unistd.h>

#include <iostream>
#include <string>

#include "command.h"
#include "gestalt/error.h"

namespace gestalt::app {

namespace {

/// One line on stderr that is drawn over itself.
class ProgressBar {
 public:
  explicit ProgressBar(std::size_t total) : total_(total), shown_(total > 1 && ::isatty(STDERR_FILENO)) {}
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::size_t done, const std::string& scene) const {
    if (!shown_) return;
    constexpr std::size_t width = 30;
    const std::size_t full = width * done / total_;
    clear();
    std::cerr << '[' << std::string(full, '#') << std::string(width - full, ' ') << "] " << done << '/' << total_ << ' '
              << scene << std::flush;
  }
  void clear() const {
    if (shown_) std::cerr << "\r\033[K" << std::flush;
  }

 private:
  std::size_t total_;
  bool shown_;
};

}  // namespace

int for_each_scene(const std::vector<std::filesystem::path>& scenes,
                   const std::function<std::string(const std::filesystem::path&)>& work) {
  const ProgressBar bar(scenes.size());
  std::size_t failed = 0;
  const auto fail = [&](const std::string& message) {
    bar.clear();
    std::cerr << "gestalt: error: " << message << '\n';
    ++failed;
  };
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    bar.show(i, scenes[i].filename().string());
    try {
      const std::string line = work(scenes[i]);
      bar.clear();
      std::cout << line << std::endl;
    } catch (const Error& error) {
      if (scenes.size() == 1) throw;
      fail(error.what());
    } catch (const std::exception& error) {
      // Not one of ours, such as no memory: it does not name what was being read.
      const std::string message = scenes[i].string() + ": " + error.what();
      if (scenes.size() == 1) throw Error(message);
      fail(message);
    }
  }
  bar.clear();
  if (failed > 0) std::cerr << "gestalt: " << failed << " of " << scenes.size() << " scenes failed\n";
  return failed > 0 ? run_failed : success;
}

}  // namespace gestalt::app
