// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "command.h"
#include "gestalt/apps/reading_options.h"
#include "gestalt/evaluation/calibration/noise_calibration.h"
#include "gestalt/io/scene/input.h"
#include "gestalt/io/scene/scene_format.h"

namespace gestalt::app::calibrate_noise_command {

namespace {

struct Options {
  std::vector<std::filesystem::path> scenes;
  ReadingOptions reading;
  bool json = false;
};

/// To four significant digits: the estimate is not better.
double rounded(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(4) << value;
  return std::stod(text.str());
}

nlohmann::ordered_json to_json(const NoiseEstimate& estimate, std::size_t scenes) {
  nlohmann::ordered_json json{{"constant", rounded(estimate.noise.constant)},
                              {"linear", rounded(estimate.noise.linear)},
                              {"quadratic", rounded(estimate.noise.quadratic)},
                              {"scenes", scenes},
                              {"bins", nlohmann::ordered_json::array()}};
  for (const NoiseBin& bin : estimate.bins)
    json["bins"].push_back({{"depth", rounded(bin.depth)},
                            {"windows", bin.windows},
                            {"samples", bin.samples},
                            {"sigma", rounded(bin.sigma)},
                            {"step", rounded(bin.step)},
                            {"model", rounded(estimate.noise.at(bin.depth))}});
  return json;
}

/// A section of a config, with the bins as comments.
void print_yaml(const NoiseEstimate& estimate, std::size_t scenes) {
  std::cout << "# sigma(z) = constant + linear z + quadratic z^2, from " << scenes
            << (scenes == 1 ? " scene\n" : " scenes\n") << "sensor:\n  noise: custom\n"
            << "  constant: " << rounded(estimate.noise.constant) << "  # m\n"
            << "  linear: " << rounded(estimate.noise.linear) << '\n'
            << "  quadratic: " << rounded(estimate.noise.quadratic) << "  # 1/m\n"
            << "# depth [m]  windows   samples  sigma [mm]  model [mm]  step of readings [mm]\n"
            << std::fixed;
  for (const NoiseBin& bin : estimate.bins)
    std::cout << '#' << std::setprecision(3) << std::setw(10) << bin.depth << std::setw(9) << bin.windows
              << std::setw(10) << bin.samples << std::setprecision(2) << std::setw(12) << 1000 * bin.sigma
              << std::setw(12) << 1000 * estimate.noise.at(bin.depth) << std::setw(23) << 1000 * bin.step << '\n';
}

int calibrate(const Options& options) {
  const ReadOptions read = read_options(options.reading);
  const std::vector<std::filesystem::path> scenes = find_scenes(options.scenes);
  NoiseCalibration calibration;
  for (const std::filesystem::path& scene : scenes) calibration.add(read_and_warn(scene, read).frame);
  const NoiseEstimate estimate = calibration.estimate();
  if (options.json)
    std::cout << to_json(estimate, scenes.size()).dump(2) << '\n';
  else
    print_yaml(estimate, scenes.size());
  return success;
}

void add_calibrate_noise(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "calibrate-noise",
      "Estimate the noise of a depth sensor from planes in its scenes, as section sensor of a config");
  command
      ->add_option("SCENES", options->scenes,
                   "Scene folders, files (" + scene_extensions(", ") + "), or folders of those, of one sensor")
      ->required();
  add_reading_options(*command, options->reading);
  command->add_flag("--json", options->json, "Print JSON");
  command->footer("Example: gestalt calibrate-noise scenes >> my_config.yaml");
  command->callback([options, &run] { run = [options] { return calibrate(*options); }; });
}

const Subcommand subcommand(150, add_calibrate_noise);

}  // namespace

}  // namespace gestalt::app::calibrate_noise_command
