// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "associations.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <sstream>
#include <string>
#include <tuple>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"
#include "gestalt/io/scene/words.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t largest_list = std::uintmax_t{1} << 28;  // bytes
constexpr std::size_t most_images = 1'000'000;                    // nine hours at 30 a second
constexpr const char* too_many = ": the list names more than 1000000 images; split the recording";
constexpr double longest_difference = 0.02;  // s, of the association of TUM's benchmark

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

/// Calls line(words, place) for every line that is not a comment (#).
template <class Line>
void read_lines(const fs::path& list, const Line& line) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";  // editors of Windows begin a text with it
  std::istringstream text(read_bytes(list, largest_list));
  std::string all;
  for (int number = 1; std::getline(text, all); ++number) {
    const std::string place = list.string() + ":" + std::to_string(number);
    if (number == 1 && all.starts_with(byte_order_mark)) all.erase(0, byte_order_mark.size());
    // The system would take what is before it for the name.
    if (all.find('\0') != all.npos)
      throw InputError(place + ": contains a NUL character, which no file's name can; write the list again as text");
    const std::vector<std::string_view> words = words_of(all);
    if (words.empty() || words[0].starts_with('#')) continue;
    line(words, place);
  }
}

std::vector<Stamped> read_list(const fs::path& folder, const char* name) {
  std::vector<Stamped> images;
  read_lines(folder / name, [&](const auto& words, const std::string& place) {
    if (images.size() == most_images) throw InputError(place + too_many);
    images.push_back(stamped(words, 0, folder, place, "timestamp filename"));
  });
  if (images.empty()) throw InputError((folder / name).string() + ": names no images");
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

/// Images of both kinds in order of time; of those of one time the first of each kind, then the second of each.
struct Moment {
  double time;
  std::size_t rank;  ///< among those of its kind and time
  bool is_depth;
  std::size_t image;  ///< in its list
};

std::vector<Moment> in_order_of_time(const std::vector<Stamped>& depths, const std::vector<Stamped>& colours) {
  std::vector<Moment> moments;
  for (const bool is_depth : {true, false}) {
    std::map<double, std::size_t> ranks;
    const std::vector<Stamped>& images = is_depth ? depths : colours;
    for (std::size_t i = 0; i < images.size(); ++i)
      moments.push_back({images[i].time, ranks[images[i].time]++, is_depth, i});
  }
  std::sort(moments.begin(), moments.end(), [](const Moment& a, const Moment& b) {
    return std::tuple(a.time, a.rank, !a.is_depth) < std::tuple(b.time, b.rank, !b.is_depth);
  });
  return moments;
}

/// Depth and colour images, the nearest in time first, each in one pair at most. Two of all that are left can be
/// nearest only where they are beside each other in order of time, so that there is one candidate for each image.
std::vector<std::pair<std::size_t, std::size_t>> nearest_in_time(const std::vector<Stamped>& depths,
                                                                 const std::vector<Stamped>& colours) {
  const std::vector<Moment> moments = in_order_of_time(depths, colours);
  const std::size_t end = moments.size();
  std::vector<std::size_t> before(end), after(end);  // of those that are left
  for (std::size_t i = 0; i < end; ++i) before[i] = i == 0 ? end : i - 1, after[i] = i + 1;
  using Candidate = std::tuple<double, std::size_t, std::size_t>;  // difference, the earlier one, the later one
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> candidates;
  const auto consider = [&](std::size_t i, std::size_t j) {
    if (i == end || j == end || moments[i].is_depth == moments[j].is_depth) return;
    const auto [depth, colour] =
        moments[i].is_depth ? std::pair(moments[i].time, moments[j].time) : std::pair(moments[j].time, moments[i].time);
    if (colour >= depth - longest_difference && colour < depth + longest_difference)
      candidates.push({std::abs(colour - depth), i, j});
  };
  for (std::size_t i = 0; i + 1 < end; ++i) consider(i, i + 1);
  std::vector<bool> used(end);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  while (!candidates.empty()) {
    const auto [difference, i, j] = candidates.top();
    candidates.pop();
    if (used[i] || used[j]) continue;
    used[i] = used[j] = true;
    pairs.emplace_back(moments[moments[i].is_depth ? i : j].image, moments[moments[i].is_depth ? j : i].image);
    const std::size_t left = before[i], right = after[j];
    if (left != end) after[left] = right;
    if (right != end) before[right] = left;
    consider(left, right);
  }
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
    if (pairs.size() == most_images) throw InputError(place + too_many);
    const char* const expected = "time rgb/FILE time depth/FILE";
    std::array<Stamped, 2> both{stamped(words, 0, folder, place, expected), {}};
    if (words.size() < 4) throw InputError(place + ": expected '" + expected + "'");
    both[1] = stamped(words, 2, folder, place, expected);
    const auto is_depth = [](std::string_view word) { return word.find("depth") != word.npos; };
    if (is_depth(words[1]) == is_depth(words[3]))
      throw InputError(
          place + ": cannot tell which of the two is the depth image; put 'depth' in its folder or file name only");
    const std::size_t depth = is_depth(words[1]) ? 0 : 1;
    pairs.push_back({both[depth].time, {both[depth].file, both[1 - depth].file}});
  });
  if (pairs.empty()) throw InputError(list.string() + ": names no images");
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
  std::vector<Timed> pairs;
  for (const auto& [depth, colour] : nearest_in_time(depths, colours))
    pairs.push_back({depths[depth].time, {depths[depth].file, colours[colour].file}});
  if (pairs.empty())
    throw InputError(folder.string() +
                     ": no colour image is within 0.02 s of a depth image; check rgb.txt and depth.txt");
  return in_order_of_time(std::move(pairs));
}

}  // namespace gestalt
