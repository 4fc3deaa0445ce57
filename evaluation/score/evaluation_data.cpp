// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <limits>
#include <random>
#include <sstream>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"
#include "gestalt/evaluation/score/evaluation.h"
#include "gestalt/io/result/result_digests.h"
#include "gestalt/io/scene/ground_truth.h"
#include "gestalt/io/scene/png_file.h"

namespace gestalt {

namespace {

constexpr std::uintmax_t largest_table = std::uintmax_t{1} << 28;  // bytes

std::vector<std::string> split_at_commas(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  std::vector<std::string> fields;
  std::size_t begin = 0, comma;
  while ((comma = line.find(',', begin)) != std::string::npos) {
    fields.push_back(line.substr(begin, comma - begin));
    begin = comma + 1;
  }
  fields.push_back(line.substr(begin));
  return fields;
}

}  // namespace

cv::Mat_<std::uint16_t> read_label_image(const std::filesystem::path& file) { return read_label_png(file); }

std::map<std::string, std::string> read_categories(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return {};
  std::istringstream in(read_bytes(file, largest_table));
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> head = split_at_commas(line);
  const auto scene = std::size_t(std::find(head.begin(), head.end(), "scene") - head.begin());
  const auto category = std::size_t(std::find(head.begin(), head.end(), "category") - head.begin());
  if (scene == head.size() || category == head.size())
    throw InputError(file.string() + ":1: the first line must name the columns scene and category");
  std::map<std::string, std::string> categories;
  for (int number = 2; std::getline(in, line); ++number) {
    const std::vector<std::string> fields = split_at_commas(line);
    if (fields.size() == 1 && fields[0].empty()) continue;
    if (fields.size() <= std::max(scene, category))
      throw InputError(file.string() + ":" + std::to_string(number) + ": has " + std::to_string(fields.size()) +
                       " fields, the first line " + std::to_string(head.size()));
    const auto [known, is_new] = categories.emplace(fields[scene], fields[category]);
    if (!is_new && known->second != fields[category])
      throw InputError(file.string() + ":" + std::to_string(number) + ": the category of '" + fields[scene] + "' is '" +
                       known->second + "' above and '" + fields[category] + "' here; keep one of the lines");
  }
  return categories;
}

cv::Mat_<std::uint16_t> read_ground_truth(const std::filesystem::path& scene, const ReadOptions& options) {
  // Of a scene folder without its camera and colour, which scores do not need.
  std::error_code error;
  if (!std::filesystem::exists(scene / "depth.png", error)) return scored_ground_truth(read_scene(scene, options));
  const cv::Mat_<std::uint16_t> depth = read_depth_png(scene / "depth.png");
  Input input;
  input.path = scene;
  read_ground_truth_beside(input, scene, depth != 0, options.labels);
  cv::Mat_<std::uint16_t> labels = require_ground_truth(input);
  labels.setTo(0, depth == 0);
  return labels;
}

bool has_prediction(const std::filesystem::path& folder, const std::string& scene, const std::string& image) {
  std::error_code error;
  return std::filesystem::is_regular_file(folder / scene / image, error) ||
         std::filesystem::is_regular_file(folder / (scene + ".png"), error);
}

cv::Mat_<std::uint16_t> read_prediction(const std::filesystem::path& folder, const std::string& scene,
                                        const std::string& image, cv::Size size) {
  const std::filesystem::path in_folder = folder / scene / image, beside = folder / (scene + ".png");
  if (!has_prediction(folder, scene, image))
    throw InputError(in_folder.string() + ": is missing, and so is " + beside.filename().string() +
                     "; every scene needs a prediction");
  const std::filesystem::path& file = std::filesystem::is_regular_file(in_folder) ? in_folder : beside;
  require_of_its_result(file);
  cv::Mat_<std::uint16_t> labels = read_label_image(file);
  if (labels.size() != size)
    throw InputError(file.string() + ": has " + std::to_string(labels.cols) + "x" + std::to_string(labels.rows) +
                     " pixels, the ground truth of the scene " + std::to_string(size.width) + "x" +
                     std::to_string(size.height) + "; segment the image at its original size");
  return labels;
}

cv::Mat_<std::uint16_t> scored_ground_truth(const Input& input) {
  cv::Mat_<std::uint16_t> labels = require_ground_truth(input).clone();
  labels.setTo(0, input.frame.depth == 0);
  return labels;
}

void require_objects(std::int64_t objects) {
  if (objects == 0)
    throw InputError(
        "no scene has an object in its ground truth, so there is nothing to train on or to score; if its label numbers "
        "count objects, give --labels objects");
}

std::vector<int> deal_folds(const std::vector<std::string>& categories, int folds, std::uint64_t seed) {
  const std::size_t scenes = categories.size();
  if (folds < 2 || std::size_t(folds) > scenes)
    throw ConfigError("cross-validation: " + std::to_string(folds) + " folds of " + std::to_string(scenes) +
                      " scenes; give at least 2 folds and a scene for each");
  std::vector<std::size_t> deck(scenes);
  for (std::size_t i = 0; i < scenes; ++i) deck[i] = i;
  // The library's shuffle and distributions may differ between compilers, its generators may not.
  std::mt19937_64 random(seed);
  if (seed != 0)
    for (std::size_t i = scenes; i > 1; --i) std::swap(deck[i - 1], deck[random() % i]);
  std::stable_sort(deck.begin(), deck.end(),
                   [&](std::size_t a, std::size_t b) { return categories[a] < categories[b]; });
  std::vector<int> fold(scenes);
  for (std::size_t i = 0; i < scenes; ++i) fold[deck[i]] = int(i % std::size_t(folds));
  return fold;
}

void PairDecisions::count(bool positive, double probability) {
  const bool decided_positive = probability >= 0.5;
  ++(positive ? decided_positive ? true_positive : false_negative : decided_positive ? false_positive : true_negative);
  Bin& bin = bins[std::min(bins.size() - 1, std::size_t(probability * double(bins.size())))];
  ++bin.pairs;
  bin.positive += positive;
  bin.probability += probability;
  squared_error += (probability - positive) * (probability - positive);
}

double PairDecisions::brier_score() const { return squared_error / double(pairs()); }

double PairDecisions::calibration_error() const {
  double sum = 0;
  for (const Bin& bin : bins) sum += std::abs(bin.probability - double(bin.positive));
  return sum / double(pairs());
}

double PairDecisions::balanced_error() const {
  const std::int64_t negative = true_negative + false_positive, positive = true_positive + false_negative;
  if (negative == 0 || positive == 0) return std::numeric_limits<double>::quiet_NaN();
  return (double(false_positive) / double(negative) + double(false_negative) / double(positive)) / 2;
}

}  // namespace gestalt
