// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/bag/bag_frames.h"

#include <algorithm>
#include <map>
#include <utility>

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/colour_image.h"
#include "gestalt/io/scene/depth_reading.h"
#include "gestalt/io/scene/image_frame.h"
#include "ros_message.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t most_apart = 30'000'000;  // ns, of depth and colour of one frame

struct Stamped {
  std::uint64_t stamp;
  MessagePlace place;
};

/// What a scan keeps of a topic.
struct Found {
  BagTopic topic;
  std::vector<Stamped> images;
  std::optional<std::string> camera;  ///< the first message
  bool camera_changes = false;
};

using Topics = std::map<std::string, Found>;

bool has_word(const std::string& name, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view word) { return name.find(word) != name.npos; });
}

/// The parts of camera_info without its header, which every message has another one of.
std::string_view without_stamp(const BagTopic& topic, std::string_view message) {
  const std::size_t header = topic.encoding == MessageEncoding::cdr ? 12 : 16;
  return message.substr(std::min(header, message.size()));
}

Topics scan(const fs::path& file, std::unique_ptr<Bag>& bag) {
  Topics found;
  bag = open_bag(file, [&](const BagTopic& topic, const MessagePlace& place, std::string_view message) {
    if (!has_images(topic) && !has_cameras(topic)) return;
    Found& of_topic = found[topic.name];
    of_topic.topic = topic;
    if (has_images(topic)) {
      of_topic.images.push_back({stamp_of(topic, message), place});
    } else if (!of_topic.camera) {
      of_topic.camera = std::string(message);
    } else if (without_stamp(topic, *of_topic.camera) != without_stamp(topic, message)) {
      of_topic.camera_changes = true;
    }
  });
  for (auto& [name, of_topic] : found) std::ranges::stable_sort(of_topic.images, {}, &Stamped::stamp);
  return found;
}

/// "/a (sensor_msgs/Image, 3 messages), /b ...".
std::string list_of(const Bag& bag) {
  std::string text;
  for (const BagTopic& topic : bag.topics())
    text += (text.empty() ? "" : ", ") + topic.name + " (" + (topic.type.empty() ? "unknown type" : topic.type) + ", " +
            std::to_string(topic.messages) + ")";
  return text.empty() ? "none" : text;
}

/// The topics of images with the highest rank; rank 0 does not count.
template <class Rank>
std::vector<std::string> best_topics(const Topics& topics, const Rank& rank) {
  std::vector<std::string> best;
  int highest = 0;
  for (const auto& [name, found] : topics) {
    if (found.images.empty()) continue;
    const int its = rank(name, found.topic);
    if (its == 0 || its < highest) continue;
    if (its > highest) best.clear();
    highest = its;
    best.push_back(name);
  }
  return best;
}

int preference(const std::string& name, const BagTopic& topic) {
  return 1 + 8 * has_word(name, {"aligned", "registered", "depth_to_rgb", "depth_to_color"}) +
         4 * has_word(name, {"rect"}) + 2 * (topic.type == "sensor_msgs/Image");
}

int depth_rank(const std::string& name, const BagTopic& topic) {
  const bool lossy = topic.type != "sensor_msgs/Image" && !has_word(name, {"compressedDepth"});
  return has_word(name, {"depth"}) && !has_word(name, {"infra", "confidence"}) && !lossy ? preference(name, topic) : 0;
}

int colour_rank(const std::string& name, const BagTopic& topic) {
  return has_word(name, {"color", "colour", "rgb"}) && !has_word(name, {"depth"}) ? preference(name, topic) : 0;
}

std::string choose(const fs::path& file, const Bag& bag, const Topics& topics, const std::string& given,
                   const std::string& what, int (*rank)(const std::string&, const BagTopic&), bool needed) {
  const std::string option = "--" + what + "-topic";
  if (!given.empty()) {
    const auto found = topics.find(given);
    if (found == topics.end() || found->second.images.empty())
      throw InputError(file.string() + ": " + option + " " + given +
                       ": is not a topic of images here; topics: " + list_of(bag));
    return given;
  }
  const std::vector<std::string> best = best_topics(topics, rank);
  if (best.size() == 1) return best.front();
  if (best.empty() && !needed) return "";
  if (best.empty())
    throw InputError(file.string() + ": has no topic of depth images; topics: " + list_of(bag) + "; give " + option);
  std::string names;
  for (const std::string& name : best) names += (names.empty() ? "" : ", ") + name;
  throw InputError(file.string() + ": several topics may be " + what + ": " + names + "; give " + option);
}

/// The camera_info beside a topic of images: /camera/depth/camera_info of /camera/depth/image_raw/compressedDepth.
const Found* camera_beside(const Topics& topics, std::string name) {
  for (std::size_t slash; (slash = name.rfind('/')) != name.npos && slash > 0;) {
    name.resize(slash);
    const auto found = topics.find(name + "/camera_info");
    if (found != topics.end() && found->second.camera) return &found->second;
  }
  return nullptr;
}

std::string name_of_stamp(std::uint64_t stamp) {
  std::string fraction = std::to_string(stamp % 1'000'000'000);
  return std::to_string(stamp / 1'000'000'000) + "." + std::string(9 - fraction.size(), '0') + fraction;
}

const Stamped* nearest(const std::vector<Stamped>& images, std::uint64_t stamp) {
  const auto after = std::ranges::lower_bound(images, stamp, {}, &Stamped::stamp);
  const Stamped* best = nullptr;
  const auto apart = [&](const Stamped& image) {
    return image.stamp > stamp ? image.stamp - stamp : stamp - image.stamp;
  };
  if (after != images.end()) best = &*after;
  if (after != images.begin() && (!best || apart(*(after - 1)) < apart(*best))) best = &*(after - 1);
  return best && apart(*best) <= most_apart ? best : nullptr;
}

}  // namespace

BagFrames::BagFrames(fs::path file, const BagTopics& given) : file_(std::move(file)) {
  const Topics topics = scan(file_, bag_);
  const std::string depth_name = choose(file_, *bag_, topics, given.depth, "depth", depth_rank, true);
  const std::string colour_name = choose(file_, *bag_, topics, given.colour, "rgb", colour_rank, false);
  const Found& depth = topics.at(depth_name);
  depth_ = depth.topic;
  notes_.push_back("depth of " + depth_name + (colour_name.empty() ? ", no colour" : ", colour of " + colour_name));
  if (!bag_->broken_off().empty())
    warnings_.push_back(file_.string() + ": " + "breaks off (" + bag_->broken_off() +
                        "); the messages before are read");

  if (const Found* camera = camera_beside(topics, depth_name)) {
    camera_ = camera_of(camera->topic, *camera->camera, has_word(depth_name, {"rect"}));
    camera_->file = file_;
    notes_.push_back("camera of " + camera->topic.name);
    if (camera->camera_changes)
      warnings_.push_back(file_.string() + ": " + camera->topic.name +
                          " changes in the recording; the first is used for all frames");
  }
  const bool registered = preference(depth_name, depth_) >= 8;
  const Found* const colour_camera = colour_name.empty() ? nullptr : camera_beside(topics, colour_name);
  if (camera_ && !registered && colour_camera &&
      without_stamp(colour_camera->topic, *colour_camera->camera) !=
          without_stamp(colour_camera->topic, *camera_beside(topics, depth_name)->camera))
    warnings_.push_back(file_.string() + ": " + "depth of " + depth_name + " and colour of " + colour_name +
                        " are of different cameras and not registered; record depth that is aligned to colour, or give "
                        "its topic with --depth-topic");

  const std::vector<Stamped> none;
  const std::vector<Stamped>& colours = colour_name.empty() ? none : topics.at(colour_name).images;
  if (!colour_name.empty()) colour_ = topics.at(colour_name).topic;
  if (std::ranges::all_of(depth.images, [](const Stamped& image) { return image.stamp == 0; }))
    throw InputError(file_.string() + ": the headers of " + depth_name +
                     " have no time stamps, by which images belong together");
  std::size_t alone = 0, repeated = 0;
  for (const Stamped& image : depth.images) {
    const std::string name = name_of_stamp(image.stamp);
    if (!frames_.empty() && frames_.back().name == name) {
      ++repeated;
      continue;
    }
    const Stamped* const colour = nearest(colours, image.stamp);
    if (!colour_name.empty() && !colour) {
      ++alone;
      continue;
    }
    frames_.push_back({name, image.place, colour ? std::optional(colour->place) : std::nullopt});
  }
  const auto count = [&](std::size_t n, const std::string& why) {
    if (n > 0)
      notes_.push_back(std::to_string(n) + " of " + std::to_string(depth.images.size()) +
                       " depth images are left out: " + why);
  };
  count(alone, "no colour image is within 0.03 s");
  count(repeated, "their time stamp is that of the one before");
  if (frames_.empty())
    throw InputError(file_.string() + ": no depth image of " + depth_name + " has a colour image of " + colour_name +
                     " within 0.03 s; are their clocks the same?");
}

ConvertedScene BagFrames::read(const BagFrame& frame, const ReadOptions& options) const try {
  const std::optional<CameraFile> camera = options.camera ? options.camera : camera_;
  if (!camera) throw InputError("no camera_info beside " + depth_.name + "; give --camera");
  const cv::Mat raw = depth_of(depth_, bag_->read(frame.depth));
  DepthReading reading = raw.type() == CV_16UC1 ? depth_reading(cv::Mat_<std::uint16_t>(raw), options, camera)
                                                : float_reading(cv::Mat_<float>(raw), options);
  const double scale = reading.whole_numbers ? reading.unit.metres : 0.001;
  Input input;
  input.path = frame.name;
  cv::Mat colour;
  if (frame.colour) colour = colour_of(colour_, bag_->read(*frame.colour));
  if (!colour.empty() && colour.size() != raw.size()) {
    if (!same_aspect(colour.size(), raw.size()))
      throw InputError("colour is of " + std::to_string(colour.cols) + "x" + std::to_string(colour.rows) +
                       " pixels, depth of " + std::to_string(raw.cols) + "x" + std::to_string(raw.rows) +
                       ", which is another view; record depth that is aligned to colour");
    colour = resized(colour, raw.size());
  }
  set_frame_of_images(input, frame.name, colour, std::move(reading), *camera, frame.name);
  return converted(input, scale);
} catch (const InputError& error) {
  throw InputError(file_.string() + ": " +
                   (std::string(error.what()).starts_with(frame.name) ? "" : frame.name + ": ") + error.what());
}

}  // namespace gestalt
