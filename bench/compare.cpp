// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Whole frames through Gestalt's configs and through PCL's segmenters, in turn frame by frame, so that whatever else
// the machine does meets all of them alike. Times begin with the frame or the cloud in memory and end with labels. What
// is scored is segmented once more: neither the label image that a score needs nor the scoring is timed.

#include <algorithm>
#include <array>
#include <functional>
#include <iostream>
#include <limits>

#include "configs.h"
#include "frames.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/output_file.h"
#include "gestalt/evaluation/score/evaluation.h"
#include "gestalt/io/scene/png_codec.h"
#include "options.h"
#include "pcl_segmentation.h"
#include "times.h"

namespace {

using namespace gestalt::bench;

using Labels = cv::Mat_<std::uint16_t>;

/// The settings of PCL's LCCP that score best; the ones of its example, which are timed, join objects with the table.
constexpr LccpSettings best_lccp{true, true, 10};

struct Contestant {
  std::string name;
  std::function<void(const gestalt::Frame&, const PclCloud::ConstPtr&)> run;
  std::function<Labels(const gestalt::Frame&, const PclCloud::ConstPtr&)> segments{};  ///< empty: finds no objects
  std::vector<double> times{};
  std::vector<gestalt::ImageScore> scores{};
};

// LCCP does not tell background from objects, so its segments and Gestalt's are scored, not Gestalt's objects.
constexpr gestalt::BackgroundRule rule = gestalt::BackgroundRule::majority;

/// The columns of scores, and the values of to_json() in them.
constexpr std::array<std::pair<const char*, const char*>, 5> score_columns{
    {{"F>.75", "majority:F>.75"}, {"oF", "majority:oF"}, {"bF", "majority:bF"}, {"P", "P"}, {"R", "R"}}};

/// The segments of PCL's LCCP as a label image.
Labels lccp_labels(const gestalt::Frame& frame, const PclCloud::ConstPtr& cloud, const LccpSettings& settings) {
  const auto segments = segment_convex(cloud, settings);
  Labels labels(frame.depth.size(), std::uint16_t{0});
  std::transform(segments->begin(), segments->end(), labels.begin(), [&](const pcl::PointXYZL& point) {
    if (point.label > std::numeric_limits<std::uint16_t>::max())
      throw gestalt::Error(frame.name + ": PCL's segment " + std::to_string(point.label) +
                           " does not fit a 16-bit label image");
    return std::uint16_t(point.label);
  });
  return labels;
}

Contestant lccp(const std::string& name, const LccpSettings& settings) {
  return {name, [settings](const auto&, const auto& cloud) { segment_convex(cloud, settings); },
          [settings](const auto& frame, const auto& cloud) { return lccp_labels(frame, cloud, settings); }};
}

std::vector<Contestant> contestants(bool scored) {
  std::vector<Contestant> all;
  for (const std::string& config : measured_configs()) {
    const auto segmenter = std::make_shared<const gestalt::Segmenter>(bundled_config(config));
    all.push_back(
        {config, [segmenter](const auto& frame, const auto&) { segmenter->segment(frame); },
         [segmenter](const auto& frame, const auto&) { return segmenter->segment(frame).segmentation.labels; }});
  }
  all.push_back({"pcl_normals", [](const auto&, const auto& cloud) { estimate_normals(cloud); }});
  all.push_back({"pcl_planes", [](const auto&, const auto& cloud) { segment_planes(cloud, estimate_normals(cloud)); }});
  all.push_back(lccp("pcl_lccp", {}));
  if (scored) all.push_back(lccp("pcl_lccp_best", best_lccp));
  return all;
}

void run(std::vector<Contestant>& all, const Frames& frames, int repeats, bool scored) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const LabelledFrame scene = frames.labelled(i);
    const PclCloud::ConstPtr cloud = to_pcl(scene.frame);
    for (int repeat = 0; repeat < repeats; ++repeat)
      for (Contestant& contestant : all)
        contestant.times.push_back(milliseconds([&] { contestant.run(scene.frame, cloud); }));
    if (!scored || scene.ground_truth.empty()) continue;
    for (Contestant& contestant : all)
      if (contestant.segments)
        contestant.scores.push_back(gestalt::score_image(scene.ground_truth, contestant.segments(scene.frame, cloud)));
  }
}

/// Writes FOLDER/<frame>.png with the segments of PCL's LCCP for every frame, for `gestalt reproduce --peer
/// LCCP=FOLDER`.
void write_lccp_labels(const Frames& frames, const std::filesystem::path& folder) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const gestalt::Frame frame = frames[i];
    gestalt::write_file(folder / (frame.name + ".png"),
                        gestalt::encode_png(lccp_labels(frame, to_pcl(frame), best_lccp)));
  }
}

/// All scores of each contestant, by its name.
nlohmann::ordered_json scores(const std::vector<Contestant>& all) {
  nlohmann::ordered_json scores;
  for (const Contestant& one : all)
    if (!one.scores.empty())
      scores[one.name] = to_json(gestalt::summarise(one.scores, std::vector<std::string>(one.scores.size()))).at("all");
  return scores;
}

/// Ratios of medians: of each to each.
nlohmann::ordered_json ratios(const std::vector<Contestant>& all) {
  nlohmann::ordered_json ratios;
  for (const Contestant& one : all)
    for (const Contestant& other : all)
      if (one.name != other.name) ratios[one.name][other.name] = median(one.times) / median(other.times);
  return ratios;
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{"Times, and with --score scores, Gestalt and PCL's segmenters on the same frames"};
  Options options;
  add_scenes(app, options);
  add_threads(app, options);
  add_measuring(app, options);
  std::filesystem::path lccp_folder;
  app.add_option("--lccp-labels", lccp_folder,
                 "Also write the label images of PCL's LCCP to this folder, DIR/<scene>.png")
      ->type_name("DIR");
  bool scored = false;
  app.add_flag("--score", scored, "Also score the segments of the frames that have labels");
  CLI11_PARSE(app, argc, argv);

  const gestalt::ThreadLimit limit(options.threads);
  std::vector<Contestant> all = contestants(scored);
  const Frames frames(options.scenes, options.synthetic);
  run(all, frames, options.repeats, scored);
  if (!lccp_folder.empty()) write_lccp_labels(frames, lccp_folder);
  nlohmann::ordered_json report = {
      {"frames", frames.size()}, {"repeats", options.repeats}, {"threads", options.threads}};
  for (const Contestant& one : all) report["milliseconds"][one.name] = spread(one.times);
  report["ratios"] = ratios(all);
  if (scored) report["scores"] = scores(all);
  if (scored && report["scores"].is_null())
    throw gestalt::InputError("--score: no frame has ground truth; give scenes with a label.png or clouds with labels");
  write_report(options, report);

  std::cout << caption(options, frames.size());
  if (scored)
    std::cout << "scores [%] of the segments of " << report["scores"]["pcl_lccp"]["images"] << " frames under the rule "
              << gestalt::background_rule_names[std::size_t(rule)] << ": " << meaning(rule)
              << "; P and R of all pixels of objects, the others means over the frames\n";
  std::cout << heading("");
  if (scored)
    for (const auto& [head, value] : score_columns) std::cout << cell(head);
  std::cout << '\n';
  for (const Contestant& one : all) {
    std::cout << row(one.name, report["milliseconds"][one.name]);
    if (!one.scores.empty())
      for (const auto& [head, value] : score_columns)
        std::cout << cell(100 * report["scores"][one.name][value].get<double>());
    std::cout << '\n';
  }
  std::cout << "medians as multiples of pcl_lccp's:\n";
  for (const Contestant& one : all)
    if (one.name != "pcl_lccp")
      std::cout << "  " << one.name << ' ' << report["ratios"][one.name]["pcl_lccp"].get<double>() << '\n';
  return 0;
} catch (const std::exception& error) {
  std::cerr << "bench_compare: error: " << error.what() << '\n';
  return 1;
}
