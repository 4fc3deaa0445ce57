// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Whole frames through a pipeline, without reading or writing files: milliseconds by level, start-up time and
// peak memory. The figures of docs/benchmarks.md come from here.

#include <sys/resource.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <opencv2/core/utility.hpp>

#include "gestalt/config.h"
#include "gestalt/input.h"
#include "gestalt/pipeline.h"
#include "gestalt/synthesis.h"

namespace {

double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, std::size_t(q * double(values.size())))];
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024;
}

/// One frame at a time, so that the peak is that of a frame.
void for_each_frame(const std::vector<std::filesystem::path>& scenes,
                    const std::function<void(const gestalt::Frame&)>& work) {
  if (scenes.empty())
    for (int i = 0; i < 10; ++i) work(gestalt::synthesize(gestalt::Category::complex_scene, 1, i).frame);
  else
    for (const auto& scene : gestalt::find_scenes(scenes)) work(gestalt::read_scene(scene).frame);
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{"Times whole frames, by level"};
  std::vector<std::filesystem::path> scenes;
  std::filesystem::path config;
  int threads = 2, repeats = 3;
  app.add_option("scenes", scenes, "Scene folders (default: ten synthetic complex scenes)");
  app.add_option("--config", config, "Config file (default: the installed default.yaml)");
  app.add_option("--threads", threads, "Threads")->check(CLI::Range(1, 1024))->capture_default_str();
  app.add_option("--repeats", repeats, "Runs of each frame")->check(CLI::Range(1, 1000))->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  using Clock = std::chrono::steady_clock;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
  cv::setNumThreads(threads);
  const auto start = Clock::now();
  const gestalt::ConfigTree tree(config.empty() ? gestalt::default_config() : config, {});
  const gestalt::Registry registry(gestalt::plugin_search_path(tree.plugin_directories()));
  const gestalt::Pipeline pipeline(tree.resolve(registry), registry);
  const gestalt::Models models = pipeline.load_models();
  const double start_up = std::chrono::duration<double, std::milli>(Clock::now() - start).count();

  std::map<std::string, std::vector<double>> times;
  std::size_t count = 0;
  for_each_frame(scenes, [&](const gestalt::Frame& frame) {
    ++count;
    for (int run = 0; run < repeats; ++run) {
      const gestalt::Percept percept = pipeline.perceive(frame);
      gestalt::LevelTimes t = percept.times;
      pipeline.decide(percept, models, &t);
      times["1 signal"].push_back(t.signal);
      times["2 primitive"].push_back(t.primitive);
      times["3 structural"].push_back(t.structural);
      times["4 assembly"].push_back(t.assembly);
      times["5 decision"].push_back(t.decision);
      times["6 whole frame"].push_back(t.total());
    }
  });
  std::cout << count << " frames, " << repeats << " runs each, " << threads << " threads; milliseconds\n"
            << std::left << std::setw(16) << "level" << std::right << std::setw(9) << "median" << std::setw(9) << "p95"
            << std::setw(9) << "worst" << '\n'
            << std::fixed << std::setprecision(1);
  for (const auto& [level, values] : times)
    std::cout << std::left << std::setw(16) << level.substr(2) << std::right << std::setw(9) << quantile(values, 0.5)
              << std::setw(9) << quantile(values, 0.95) << std::setw(9) << quantile(values, 1) << '\n';
  std::cout << "config, plugins and model loaded in " << start_up << " ms; peak memory " << peak_megabytes() << " MB\n";
  return 0;
} catch (const std::exception& error) {
  std::cerr << "bench_frame: error: " << error.what() << '\n';
  return 1;
}
