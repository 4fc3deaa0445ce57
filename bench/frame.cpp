// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Whole frames through a pipeline, without reading or writing files: milliseconds by level, what is allocated for a
// frame, and peak memory.

#include <sys/resource.h>

#include <iostream>

#include "allocations.h"
#include "configs.h"
#include "frames.h"
#include "options.h"
#include "times.h"

namespace {

using namespace gestalt::bench;
using gestalt::LevelTimes;

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024;
}

/// What was measured, one value a run of a frame.
struct Runs {
  std::vector<double> signal, primitive, structural, assembly, decision, whole_frame;
  std::vector<double> allocations, allocated_bytes;

  void add(const LevelTimes& times, const Allocations& before, const Allocations& after) {
    signal.push_back(times.signal);
    primitive.push_back(times.primitive);
    structural.push_back(times.structural);
    assembly.push_back(times.assembly);
    decision.push_back(times.decision);
    whole_frame.push_back(times.total());
    allocations.push_back(double(after.count - before.count));
    allocated_bytes.push_back(double(after.bytes - before.bytes));
  }
};

Runs run(const gestalt::Segmenter& segmenter, const Frames& frames, int repeats) {
  Runs runs;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const gestalt::Frame frame = frames[i];
    for (int repeat = 0; repeat < repeats; ++repeat) {
      const Allocations before = allocations();
      const LevelTimes times = segmenter.segment(frame).times;
      runs.add(times, before, allocations());
    }
  }
  return runs;
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{"Times whole frames, by level"};
  Options options;
  add_scenes(app, options);
  add_config(app, options);
  add_threads(app, options);
  add_measuring(app, options);
  CLI11_PARSE(app, argc, argv);

  const gestalt::ThreadLimit limit(options.threads);
  const gestalt::Segmenter segmenter(options.config);
  const Frames frames(options.scenes, options.synthetic);
  const Runs runs = run(segmenter, frames, options.repeats);
  const nlohmann::ordered_json report = {{"config", options.config.filename().string()},
                                         {"frames", frames.size()},
                                         {"repeats", options.repeats},
                                         {"threads", options.threads},
                                         {"milliseconds",
                                          {{"signal", spread(runs.signal)},
                                           {"primitive", spread(runs.primitive)},
                                           {"structural", spread(runs.structural)},
                                           {"assembly", spread(runs.assembly)},
                                           {"decision", spread(runs.decision)},
                                           {"whole_frame", spread(runs.whole_frame)}}},
                                         {"allocations", spread(runs.allocations)},
                                         {"allocated_bytes", spread(runs.allocated_bytes)},
                                         {"peak_megabytes", peak_megabytes()}};
  write_report(options, report);

  std::cout << caption(options, frames.size()) << heading("level") << '\n';
  for (const auto& [level, times] : report["milliseconds"].items()) std::cout << row(level, times) << '\n';
  std::cout << "median frame: " << median(runs.allocations) << " allocations of "
            << median(runs.allocated_bytes) / (1 << 20) << " MB in sum; peak memory " << peak_megabytes() << " MB\n";
  return 0;
} catch (const std::exception& error) {
  std::cerr << "bench_frame: error: " << error.what() << '\n';
  return 1;
}
