// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/dataset/tum_sequence.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"
#include "gestalt/io/scene/words.h"
#include "image_set.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

// What the benchmark's page says of its files: the factory's camera, and 5000 units a metre.
constexpr Camera tum_camera{640, 480, 525, 525, 319.5, 239.5};
constexpr double tum_depth_scale = 1.0 / 5000;
constexpr std::uintmax_t largest_list = std::uintmax_t{1} << 28;  // bytes
constexpr double longest_difference = 0.02;                       // s, of the benchmark's own association

struct Stamped {
  double time;
  fs::path file;
};

/// Lines "time file"; # begins a comment.
std::vector<Stamped> read_list(const fs::path& sequence, const char* name) {
  const fs::path list = sequence / name;
  std::istringstream text(read_bytes(list, largest_list));
  std::vector<Stamped> images;
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) {
    const std::vector<std::string_view> words = words_of(line);
    if (words.empty() || words[0].starts_with('#')) continue;
    double time = 0;
    const char* const end = words[0].data() + words[0].size();
    const auto [last, error] = std::from_chars(words[0].data(), end, time);
    if (words.size() < 2 || error != std::errc{} || last != end || !std::isfinite(time))
      throw InputError(list.string() + ":" + std::to_string(number) + ": expected 'timestamp filename'");
    images.push_back({time, sequence / words[1]});
  }
  if (images.empty()) throw InputError(list.string() + ": names no image");
  return images;
}

}  // namespace

std::vector<TumFrame> find_tum_frames(const fs::path& sequence) {
  const std::vector<Stamped> colours = read_list(sequence, "rgb.txt"), depths = read_list(sequence, "depth.txt");
  struct Match {
    double difference;
    std::size_t depth, colour;
  };
  std::vector<std::size_t> by_time(colours.size());
  for (std::size_t i = 0; i < by_time.size(); ++i) by_time[i] = i;
  std::sort(by_time.begin(), by_time.end(),
            [&](std::size_t a, std::size_t b) { return colours[a].time < colours[b].time; });
  std::vector<Match> matches;
  for (std::size_t d = 0; d < depths.size(); ++d) {
    const double first = depths[d].time - longest_difference;
    auto c = std::lower_bound(by_time.begin(), by_time.end(), first,
                              [&](std::size_t colour, double time) { return colours[colour].time < time; });
    for (; c != by_time.end() && colours[*c].time < depths[d].time + longest_difference; ++c)
      matches.push_back({std::abs(colours[*c].time - depths[d].time), d, *c});
  }
  // The nearest in time first; each image is in one frame at most.
  std::stable_sort(matches.begin(), matches.end(),
                   [](const Match& a, const Match& b) { return a.difference < b.difference; });
  std::vector<bool> colour_used(colours.size()), depth_used(depths.size());
  std::vector<std::pair<double, TumFrame>> frames;
  for (const Match& match : matches) {
    if (colour_used[match.colour] || depth_used[match.depth]) continue;
    colour_used[match.colour] = depth_used[match.depth] = true;
    frames.push_back({depths[match.depth].time, {depths[match.depth].file, colours[match.colour].file}});
  }
  if (frames.empty())
    throw InputError(sequence.string() +
                     ": no colour image is within 0.02 s of a depth image; check rgb.txt and depth.txt");
  std::stable_sort(frames.begin(), frames.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<TumFrame> sorted;
  sorted.reserve(frames.size());
  for (auto& [time, frame] : frames) sorted.push_back(std::move(frame));
  return sorted;
}

ConvertedScene read_tum_frame(const TumFrame& frame, const ReadOptions& options) {
  ConvertedScene scene;
  scene.camera = options.camera ? options.camera->camera : tum_camera;
  scene.depth_scale = scale_of(options, tum_depth_scale);
  scene.images = read_images(frame.depth, frame.colour, scene.camera);
  question(scene, frame.depth, options);
  return scene;
}

}  // namespace gestalt
