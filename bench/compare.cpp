// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Whole frames through Gestalt's configs and through PCL's segmenters, in turn frame by frame, so that whatever else
// the machine does meets all of them alike. Times begin with the frame or the cloud in memory and end with labels.

#include <algorithm>
#include <functional>
#include <iostream>
#include <limits>

#include "configs.h"
#include "frames.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/output_file.h"
#include "gestalt/io/scene/png_codec.h"
#include "options.h"
#include "pcl_segmentation.h"
#include "times.h"

namespace {

using namespace gestalt::bench;

struct Contestant {
  std::string name;
  std::function<void(const gestalt::Frame&, const PclCloud::ConstPtr&)> run;
  std::vector<double> times{};
};

std::vector<Contestant> contestants() {
  std::vector<Contestant> all;
  for (const std::string& config : measured_configs()) {
    const auto segmenter = std::make_shared<const gestalt::Segmenter>(bundled_config(config));
    all.push_back({config, [segmenter](const auto& frame, const auto&) { segmenter->segment(frame); }});
  }
  all.push_back({"pcl_normals", [](const auto&, const auto& cloud) { estimate_normals(cloud); }});
  all.push_back({"pcl_planes", [](const auto&, const auto& cloud) { segment_planes(cloud, estimate_normals(cloud)); }});
  all.push_back({"pcl_lccp", [](const auto&, const auto& cloud) { segment_convex(cloud); }});
  return all;
}

void run(std::vector<Contestant>& all, const Frames& frames, int repeats) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const gestalt::Frame frame = frames[i];
    const PclCloud::ConstPtr cloud = to_pcl(frame);
    for (int repeat = 0; repeat < repeats; ++repeat)
      for (Contestant& contestant : all)
        contestant.times.push_back(milliseconds([&] { contestant.run(frame, cloud); }));
  }
}

/// Writes FOLDER/<frame>.png with the segments of PCL's LCCP for every frame, for `gestalt reproduce --peer
/// LCCP=FOLDER`. The settings are those that score best; the ones that are timed join objects with the table.
void write_lccp_labels(const Frames& frames, const std::filesystem::path& folder) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const gestalt::Frame frame = frames[i];
    const auto segments = segment_convex(to_pcl(frame), {true, true, 10});
    cv::Mat_<std::uint16_t> labels(frame.depth.size(), std::uint16_t{0});
    std::transform(segments->begin(), segments->end(), labels.begin(), [&](const pcl::PointXYZL& point) {
      if (point.label > std::numeric_limits<std::uint16_t>::max())
        throw gestalt::Error(frame.name + ": PCL's segment " + std::to_string(point.label) +
                             " does not fit a 16-bit label image");
      return std::uint16_t(point.label);
    });
    gestalt::write_file(folder / (frame.name + ".png"), gestalt::encode_png(labels));
  }
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
  CLI::App app{"Times Gestalt and PCL's segmenters on the same frames"};
  Options options;
  add_scenes(app, options);
  add_threads(app, options);
  add_measuring(app, options);
  std::filesystem::path lccp_labels;
  app.add_option("--lccp-labels", lccp_labels,
                 "Also write the label images of PCL's LCCP to this folder, DIR/<scene>.png")
      ->type_name("DIR");
  CLI11_PARSE(app, argc, argv);

  const gestalt::ThreadLimit limit(options.threads);
  std::vector<Contestant> all = contestants();
  const Frames frames(options.scenes, options.synthetic);
  run(all, frames, options.repeats);
  if (!lccp_labels.empty()) write_lccp_labels(frames, lccp_labels);
  nlohmann::ordered_json report = {
      {"frames", frames.size()}, {"repeats", options.repeats}, {"threads", options.threads}};
  for (const Contestant& one : all) report["milliseconds"][one.name] = spread(one.times);
  report["ratios"] = ratios(all);
  write_report(options, report);

  std::cout << caption(options, frames.size()) << heading("") << '\n';
  for (const Contestant& one : all) std::cout << row(one.name, report["milliseconds"][one.name]) << '\n';
  std::cout << "medians as multiples of pcl_lccp's:\n";
  for (const Contestant& one : all)
    if (one.name != "pcl_lccp")
      std::cout << "  " << one.name << ' ' << report["ratios"][one.name]["pcl_lccp"].get<double>() << '\n';
  return 0;
} catch (const std::exception& error) {
  std::cerr << "bench_compare: error: " << error.what() << '\n';
  return 1;
}
