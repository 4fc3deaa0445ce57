// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scene_batch.h"

#include <iostream>
#include <string>

#include "command.h"
#include "gestalt/error.h"
#include "progress_bar.h"

namespace gestalt::app {

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
