// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <atomic>
#include <cstdint>
#include <iomanip>
#include <iostream>

#include "command.h"
#include "gestalt/apps/counted.h"
#include "gestalt/apps/depth_only.h"
#include "gestalt/apps/next_step.h"
#include "gestalt/apps/output_check.h"
#include "gestalt/apps/pipeline_options.h"
#include "gestalt/apps/reading_options.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/for_all.h"
#include "gestalt/core/base/output_file.h"
#include "gestalt/core/pipeline/learning_set.h"
#include "gestalt/evaluation/score/evaluation.h"
#include "gestalt/io/scene/ground_truth.h"
#include "gestalt/io/scene/input.h"

namespace gestalt::app::train_command {

namespace {

struct Options {
  std::vector<std::filesystem::path> scenes;
  std::filesystem::path output;
  ReadingOptions reading;
  PipelineOptions pipeline;
};

void print_model(const Model& model, Level level) {
  std::cout << name_of(level) << " level: " << model.classifier << " trained on "
            << counted(model.training.scenes.size(), "scene") << ", " << model.training.positive_pairs
            << " positive and " << model.training.negative_pairs << " negative pairs\n"
            << "value      scaled from\n";
  for (std::size_t i = 0; i < model.names.size(); ++i)
    std::cout << std::left << std::setw(10) << model.names[i] << " [" << model.scaling.low[i] << ", "
              << model.scaling.high[i] << "]\n";
}

int train(const Options& options) {
  const ThreadLimit limit(options.pipeline.threads);
  const std::vector<std::filesystem::path> scenes = find_scenes(options.scenes);
  require_of_no_scene("--output", options.output, scenes);
  require_not_read("--output", options.output, {options.pipeline.config, options.reading.camera});
  const ReadOptions read = read_options(options.reading);
  const PipelineOptions chosen =
      options_for_all(options.pipeline, scenes, read, "; use the model with --config depth_only.yaml, too");
  const LoadedConfig loaded = load_config(chosen);
  const Pipeline pipeline(loaded.config, loaded.registry);

  // A scene that cannot be used ends the training: a model must not silently lack what it was asked to learn.
  std::vector<LearningScene> perceived(scenes.size());
  std::atomic<std::int64_t> objects = 0;
  for_all(scenes.size(), [&](std::size_t i) {
    const Input input = read_one_of_many(scenes[i], read, chosen);
    perceived[i] = make_learning_scene(pipeline, input.frame, require_ground_truth(input));
    objects += count_objects(input.ground_truth);
  });
  require_objects(objects);
  std::vector<const LearningScene*> all;
  all.reserve(perceived.size());
  for (const LearningScene& scene : perceived) all.push_back(&scene);
  const Models models = learn(pipeline, all);
  remove_abandoned(std::filesystem::absolute(options.output).parent_path());
  write_models(options.output, models);
  std::cout << options.output.string() << '\n';
  print_model(models.structural, Level::structural);
  if (models.assembly) print_model(*models.assembly, Level::assembly);
  std::vector<std::string> use{"segment", "INPUT"};
  if (!chosen.config.empty()) use.insert(use.end(), {"--config", chosen.config});
  for (const std::string& value : chosen.overrides) use.insert(use.end(), {"--set", value});
  use.insert(use.end(), {"--set", "model=" + options.output.string()});
  suggest_next("Use the model", use);
  return success;
}

void add_train(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("train", "Train a model on scenes with ground truth");
  command->add_option("scenes", options->scenes, "Scene folders with label.png, or folders of those")
      ->required()
      ->type_name("SCENES");
  command->add_option("--output", options->output, "Model file to write")->required()->type_name("MODEL");
  add_reading_options(*command, options->reading);
  add_pipeline_options(*command, options->pipeline);
  command->footer(
      "Example: gestalt train scenes --output models/mine.json\n"
      "Use it:  gestalt segment INPUT --set model=models/mine.json");
  command->callback([options, &run] { run = [options] { return train(*options); }; });
}

const Subcommand subcommand(30, add_train);

}  // namespace

}  // namespace gestalt::app::train_command
