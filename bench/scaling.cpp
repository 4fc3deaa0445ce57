// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// How time grows with the size of a frame: with its pixels (one synthetic scene at several resolutions, the whole
// frame), with its patches (frames of facets, the structural level) and with the pairs of these (the assembly level).

#include <algorithm>
#include <functional>
#include <iomanip>
#include <iostream>

#include "configs.h"
#include "facets.h"
#include "gestalt/synthesis/synthesis.h"
#include "options.h"
#include "times.h"

namespace {

using namespace gestalt::bench;
using gestalt::Frame;
using gestalt::LevelTimes;
using nlohmann::ordered_json;

/// A frame and the times of its runs.
struct Measured {
  Frame frame;
  std::size_t patches = 0;  ///< that are large enough for relations at the structural level
  std::size_t pairs = 0;    ///< of the assembly level
  std::vector<LevelTimes> runs{};

  double median_of(const std::function<double(const LevelTimes&)>& level) const {
    std::vector<double> times;
    for (const LevelTimes& run : runs) times.push_back(level(run));
    return median(times);
  }
};

void run(Measured& one, const gestalt::Segmenter& segmenter) {
  const gestalt::Percept percept = segmenter.pipeline().perceive(one.frame);
  one.runs.push_back(percept.times);
  segmenter.pipeline().decide(percept, segmenter.models(), &one.runs.back());
  const double smallest = segmenter.config().structural.minimum_size * percept.pixel_density;
  const auto& surfaces = percept.surfaces().surfaces;
  one.patches = std::size_t(std::count_if(surfaces.begin(), surfaces.end(), [&](const gestalt::Surface& surface) {
    return double(surface.pixels.size()) >= smallest;
  }));
  one.pairs = percept.assembly.pairs.size();
}

/// Runs the frames in turn, so that whatever else the machine does meets all of them alike.
void run(std::vector<Measured>& all, const gestalt::Segmenter& segmenter, int repeats) {
  for (int repeat = 0; repeat < repeats; ++repeat)
    for (Measured& one : all) run(one, segmenter);
}

std::vector<Measured> resolutions(bool quick) {
  std::vector<Measured> frames;
  for (const int width : quick ? std::vector{320, 640} : std::vector{320, 640, 1280, 1920, 3840}) {
    const gestalt::Camera camera = gestalt::kinect_camera(width, width * 3 / 4);
    frames.push_back({gestalt::synthesize(gestalt::Category::complex_scene, 1, 0, camera).frame});
  }
  return frames;
}

std::vector<Measured> patch_counts(bool quick) {
  std::vector<Measured> frames;
  frames.push_back({facets(10, 10)});
  frames.push_back({facets(20, 10)});
  if (quick) return frames;
  frames.push_back({facets(20, 20)});
  frames.push_back({facets(40, 20)});
  return frames;
}

/// One entry for each frame: its size, the time, and both as multiples of those of the reference frame.
ordered_json growth(const std::vector<Measured>& all, std::size_t reference,
                    const std::function<double(const Measured&)>& size,
                    const std::function<double(const LevelTimes&)>& level) {
  const double size_there = size(all[reference]), time_there = all[reference].median_of(level);
  ordered_json entries = ordered_json::array();
  for (const Measured& one : all) {
    const double time = one.median_of(level);
    entries.push_back({{"size", size(one)},
                       {"milliseconds", time},
                       {"size_ratio", size(one) / size_there},
                       {"time_ratio", time / time_there}});
  }
  return entries;
}

void print(const std::string& what, const ordered_json& entries) {
  std::cout << what << '\n' << std::setprecision(3);
  for (const auto& entry : entries)
    std::cout << std::setw(12) << std::size_t(entry["size"].get<double>()) << std::setw(10)
              << entry["milliseconds"].get<double>() << " ms   size x " << std::setw(6)
              << entry["size_ratio"].get<double>() << "   time x " << entry["time_ratio"].get<double>() << '\n';
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{"Times frames of growing size"};
  Options options;
  options.repeats = 5;
  add_config(app, options);
  add_threads(app, options);
  add_measuring(app, options);
  CLI11_PARSE(app, argc, argv);

  const gestalt::ThreadLimit limit(options.threads);
  const gestalt::Segmenter segmenter(options.config);
  std::vector<Measured> by_pixels = resolutions(options.quick), by_patches = patch_counts(options.quick);
  run(by_pixels, segmenter, options.repeats);
  run(by_patches, segmenter, options.repeats);

  constexpr std::size_t vga = 1, fewest = 0;
  const ordered_json report = {
      {"config", options.config.filename().string()},
      {"repeats", options.repeats},
      {"threads", options.threads},
      {"pixels",
       growth(
           by_pixels, vga, [](const Measured& one) { return double(one.frame.depth.total()); }, &LevelTimes::total)},
      {"patches",
       growth(
           by_patches, fewest, [](const Measured& one) { return double(one.patches); }, &LevelTimes::structural)},
      {"pairs", growth(
                    by_patches, fewest, [](const Measured& one) { return double(one.pairs); }, &LevelTimes::assembly)}};
  write_report(options, report);

  print("pixels, whole frame", report["pixels"]);
  print("patches, structural level", report["patches"]);
  print("pairs, assembly level", report["pairs"]);
  return 0;
} catch (const std::exception& error) {
  std::cerr << "bench_scaling: error: " << error.what() << '\n';
  return 1;
}
