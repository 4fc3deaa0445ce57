// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "associations.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"
#include "gestalt/io/scene/words.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t largest_list = std::uintmax_t{1} << 28;  // bytes
constexpr double longest_difference = 0.02;                       // s, of the association of TUM's benchmark

struct Stamped {
  double time;
  fs::path file;
};

/// The time and the file at a place of a line's words.
Stamped stamped(const std::vector<std::string_view>& words, std::size_t at, const fs::path& folder,
                const std::string& place, const char* expected) {
  double time = 0;
  const char* const end = words[at].data() + words[at].size();
  const auto [last, error] = std::from_chars(words[at].data(), end, time);
  if (words.size() < at + 2 || error != std::errc{} || last != end || !std::isfinite(time))
    throw InputError(place + ": expected '" + expected + "'");
  return {time, folder / words[at + 1]};
}

/// Calls line(words, place) for every line that is no comment (#).
template <class Line>
void read_lines(const fs::path& list, const Line& line) {
  std::istringstream text(read_bytes(list, largest_list));
  std::string all;
  for (int number = 1; std::getline(text, all); ++number) {
    const std::vector<std::string_view> words = words_of(all);
    if (words.empty() || words[0].starts_with('#')) continue;
    line(words, list.string() + ":" + std::to_string(number));
  }
}

std::vector<Stamped> read_list(const fs::path& folder, const char* name) {
  std::vector<Stamped> images;
  read_lines(folder / name, [&](const auto& words, const std::string& place) {
    images.push_back(stamped(words, 0, folder, place, "timestamp filename"));
  });
  if (images.empty()) throw InputError((folder / name).string() + ": names no image");
  return images;
}

using Timed = std::pair<double, FrameFiles>;

std::vector<FrameFiles> in_order_of_time(std::vector<Timed> timed) {
  std::stable_sort(timed.begin(), timed.end(), [](const Timed& a, const Timed& b) { return a.first < b.first; });
  std::vector<FrameFiles> pairs;
  pairs.reserve(timed.size());
  for (Timed& one : timed) pairs.push_back(std::move(one.second));
  return pairs;
}

fs::path list_of_pairs(const fs::path& folder) {
  std::error_code ignored;
  for (const char* name : {"associations.txt", "association.txt", "associate.txt", "associated.txt"})
    if (fs::is_regular_file(folder / name, ignored)) return folder / name;
  return {};
}

std::vector<FrameFiles> listed_pairs(const fs::path& list, const fs::path& folder) {
  std::vector<Timed> pairs;
  read_lines(list, [&](const auto& words, const std::string& place) {
    const char* const expected = "time rgb/FILE time depth/FILE";
    std::array<Stamped, 2> both{stamped(words, 0, folder, place, expected), {}};
    if (words.size() < 4) throw InputError(place + ": expected '" + expected + "'");
    both[1] = stamped(words, 2, folder, place, expected);
    const auto is_depth = [](std::string_view word) { return word.find("depth") != word.npos; };
    if (is_depth(words[1]) == is_depth(words[3]))
      throw InputError(place +
                       ": which of the two is the depth image? Have 'depth' in its folder or name, and in no other");
    const std::size_t depth = is_depth(words[1]) ? 0 : 1;
    pairs.push_back({both[depth].time, {both[depth].file, both[1 - depth].file}});
  });
  if (pairs.empty()) throw InputError(list.string() + ": names no image");
  return in_order_of_time(std::move(pairs));
}

}  // namespace

bool has_associations(const fs::path& folder) {
  std::error_code ignored;
  return !list_of_pairs(folder).empty() ||
         (fs::is_regular_file(folder / "rgb.txt", ignored) && fs::is_regular_file(folder / "depth.txt", ignored));
}

std::vector<FrameFiles> associated_images(const fs::path& folder) {
  if (const fs::path list = list_of_pairs(folder); !list.empty()) return listed_pairs(list, folder);
  const std::vector<Stamped> colours = read_list(folder, "rgb.txt"), depths = read_list(folder, "depth.txt");
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
  // The nearest in time first; each image is in one pair at most.
  std::stable_sort(matches.begin(), matches.end(),
                   [](const Match& a, const Match& b) { return a.difference < b.difference; });
  std::vector<bool> colour_used(colours.size()), depth_used(depths.size());
  std::vector<Timed> pairs;
  for (const Match& match : matches) {
    if (colour_used[match.colour] || depth_used[match.depth]) continue;
    colour_used[match.colour] = depth_used[match.depth] = true;
    pairs.push_back({depths[match.depth].time, {depths[match.depth].file, colours[match.colour].file}});
  }
  if (pairs.empty())
    throw InputError(folder.string() +
                     ": no colour image is within 0.02 s of a depth image; check rgb.txt and depth.txt");
  return in_order_of_time(std::move(pairs));
}

}  // namespace gestalt
