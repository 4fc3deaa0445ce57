// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scene_tracker.h"

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>
#include <vector>

#include "gestalt/core/base/error.h"

namespace gestalt::app {

namespace {

using Json = nlohmann::json;

/// The whole word as a finite number, whatever the locale.
std::optional<double> number_of(const std::string& word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Nothing unless there are seven numbers, of which the last four are a rotation.
std::optional<Eigen::Isometry3d> pose_of(const std::vector<std::string>& words) {
  if (words.size() != 7) return std::nullopt;
  std::array<double, 7> numbers{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto number = number_of(words[i]);
    if (!number) return std::nullopt;
    numbers[i] = *number;
  }
  const Eigen::Quaterniond rotation(numbers[6], numbers[3], numbers[4], numbers[5]);
  if (!(std::abs(rotation.norm() - 1) < 0.01)) return std::nullopt;
  return Eigen::Translation3d(numbers[0], numbers[1], numbers[2]) * rotation.normalized();
}

Json changes_json(const std::vector<FrameTracks::Change>& changes) {
  Json all = Json::array();
  for (const auto& change : changes) all.push_back({{"from", change.from}, {"into", change.into}});
  return all;
}

}  // namespace

std::map<std::string, Eigen::Isometry3d> read_poses(const std::filesystem::path& file) {
  std::ifstream text(file);
  if (!text) throw InputError(file.string() + ": cannot be read");
  std::map<std::string, Eigen::Isometry3d> poses;
  std::size_t number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    const std::string place = file.string() + ":" + std::to_string(number) + ": ";
    std::istringstream rest(line);
    std::string name;
    if (!(rest >> name) || name[0] == '#') continue;
    std::vector<std::string> words;
    for (std::string word; rest >> word;) words.push_back(word);
    const auto pose = pose_of(words);
    if (!pose)
      throw InputError(place +
                       "expected a frame's name and seven numbers, tx ty tz in metres and the unit quaternion "
                       "qx qy qz qw");
    if (!poses.emplace(name, *pose).second)
      throw InputError(std::string(place)
                           .append("the frame '")
                           .append(name)
                           .append("' has a pose already; remove one of the two lines"));
  }
  if (text.bad()) throw InputError(file.string() + ": cannot be read");
  if (poses.empty()) throw InputError(file.string() + ": has no pose; leave out --poses if there is none");
  return poses;
}

SceneTracker::SceneTracker(int keep, const std::filesystem::path& poses) : file_(poses) {
  TrackerParams params;
  params.keep = keep;
  tracker_ = Tracker(params);
  if (!file_.empty()) poses_ = read_poses(file_);
}

Json SceneTracker::update(const std::string& name, const SegmentedFrame& found) {
  std::optional<Eigen::Isometry3d> pose;
  if (!file_.empty()) {
    const auto known = poses_.find(name);
    if (known == poses_.end())
      throw InputError(file_.string() + ": has no pose of the frame '" + name +
                       "'; add its line, or leave out --poses");
    pose = known->second;
  }
  const std::vector<ObjectDescription> objects = describe_objects(found);
  const FrameTracks tracks = tracker_.update(found.percept.frame(), found.segmentation.labels, objects, pose);
  Json numbers = Json::array();
  for (std::size_t i = 0; i < objects.size(); ++i)
    numbers.push_back({{"label", objects[i].label}, {"track", tracks.numbers[i]}});
  return {{"objects", std::move(numbers)},
          {"new", tracks.appeared},
          {"hidden", tracks.hidden},
          {"lost", tracks.lost},
          {"split", changes_json(tracks.split)},
          {"merged", changes_json(tracks.merged)}};
}

}  // namespace gestalt::app
