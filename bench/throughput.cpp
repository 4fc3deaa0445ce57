// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Many frames in parallel, one thread against several: frames a second and the gain.

#include <iostream>

#include "configs.h"
#include "frames.h"
#include "gestalt/core/base/for_all.h"
#include "options.h"
#include "times.h"

namespace {

using namespace gestalt::bench;

double frames_per_second(const gestalt::Segmenter& segmenter, const std::vector<gestalt::Frame>& frames, int threads) {
  const gestalt::ThreadLimit limit(threads);
  const double time =
      milliseconds([&] { gestalt::for_all(frames.size(), [&](std::size_t i) { segmenter.segment(frames[i]); }); });
  return 1000 * double(frames.size()) / time;
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{"Frames a second with one thread and with several"};
  Options options;
  add_scenes(app, options);
  add_config(app, options);
  add_threads(app, options);
  add_measuring(app, options);
  CLI11_PARSE(app, argc, argv);

  const gestalt::Segmenter segmenter(options.config);
  const std::vector<gestalt::Frame> frames = Frames(options.scenes, options.synthetic).all();
  std::vector<double> one, several;
  for (int repeat = 0; repeat < options.repeats; ++repeat) {  // in turn: the machine's other work meets both alike
    one.push_back(frames_per_second(segmenter, frames, 1));
    several.push_back(frames_per_second(segmenter, frames, options.threads));
  }
  const nlohmann::ordered_json report = {
      {"config", options.config.filename().string()},
      {"frames", frames.size()},
      {"repeats", options.repeats},
      {"threads", options.threads},
      {"frames_per_second", {{"one_thread", median(one)}, {"all_threads", median(several)}}},
      {"gain", median(several) / median(one)}};
  write_report(options, report);
  std::cout << frames.size() << " frames: " << median(one) << " frames/s with one thread, " << median(several)
            << " with " << options.threads << ", gain " << report["gain"].get<double>() << '\n';
  return 0;
} catch (const std::exception& error) {
  std::cerr << "bench_throughput: error: " << error.what() << '\n';
  return 1;
}
