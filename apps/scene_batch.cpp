// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scene_batch.h"

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <iostream>
#include <new>

#include "gestalt/apps/commands/command.h"
#include "gestalt/core/base/error.h"
#include "interruption.h"
#include "progress_bar.h"

namespace gestalt::app {

namespace {

/// What came of a scene.
struct Outcome {
  std::string line;
  bool failed = false;
};

/// Runs work(scene) on its own: what it throws stays in the outcome, so that it does not cancel the other scenes, and a
/// thread that waits inside it does not start another scene, so that no more scenes are in memory than threads run.
Outcome outcome_of(const std::filesystem::path& scene, const SceneWork& work) {
  return tbb::this_task_arena::isolate([&]() -> Outcome {
    try {
      return {work(scene)};
    } catch (const std::exception& error) {
      return {failure_message(scene, error), true};
    }
  });
}

/// The exit code says why the only scene failed.
int only(const std::filesystem::path& scene, const SceneWork& work) {
  try {
    std::cout << work(scene) << std::endl;
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(failure_message(scene, error));
  }
  return success;
}

}  // namespace

std::string failure_message(const std::filesystem::path& scene, const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error)) {
    std::error_code ignored;
    const auto bytes =
        std::filesystem::is_regular_file(scene, ignored) ? std::filesystem::file_size(scene, ignored) : 0;
    return scene.string() + ": " + (bytes > 0 ? "its " + std::to_string(bytes) + " bytes take" : "takes") +
           " more memory than this process may use; raise its memory limit, or process fewer scenes at once with "
           "--threads 1";
  }
  return dynamic_cast<const Error*>(&error) ? error.what() : scene.string() + ": " + error.what();
}

int for_each_scene(const std::vector<std::filesystem::path>& scenes, const SceneWork& work) {
  const Interruption interruption;
  const auto exit_code = [&](int otherwise) {
    return interruption.requested() ? 128 + interruption.signal() : otherwise;
  };
  if (scenes.size() == 1) return exit_code(only(scenes[0], work));
  const ProgressBar bar(scenes.size());
  std::size_t next = 0, reported = 0, failed = 0;
  const auto show = [&] {
    if (reported < scenes.size()) bar.show(reported, scenes[reported].filename().string());
  };
  const auto report = [&](const Outcome& outcome) {
    bar.clear();
    if (outcome.failed) {
      std::cerr << "gestalt: error: " << outcome.line << '\n';
      ++failed;
    } else {
      std::cout << outcome.line << std::endl;
    }
    ++reported;
    show();
  };
  show();
  // A slow scene holds back the lines of those after it, which are all that is kept of them, but not their work.
  const std::size_t started = 8 * tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  tbb::parallel_pipeline(
      started, tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, [&](tbb::flow_control& control) {
                 if (next == scenes.size() || interruption.requested()) control.stop();
                 return next++;
               }) & tbb::make_filter<std::size_t, Outcome>(tbb::filter_mode::parallel, [&](std::size_t i) {
                 return outcome_of(scenes[i], work);
               }) & tbb::make_filter<Outcome, void>(tbb::filter_mode::serial_in_order, report));
  bar.clear();
  if (failed > 0) std::cerr << "gestalt: " << failed << " of " << scenes.size() << " scenes failed\n";
  if (interruption.requested())
    std::cerr << "gestalt: interrupted: " << scenes.size() - reported << " of " << scenes.size()
              << " scenes were not started\n";
  return exit_code(failed > 0 ? run_failed : success);
}

}  // namespace gestalt::app
