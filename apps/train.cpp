// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <tbb/parallel_for.h>

#include <iomanip>
#include <iostream>

#include "command.h"
#include "gestalt/error.h"
#include "gestalt/input.h"
#include "gestalt/learning_set.h"
#include "pipeline_options.h"

namespace gestalt::app {

namespace {

struct Options {
  std::vector<std::filesystem::path> scenes;
  std::filesystem::path output;
  PipelineOptions pipeline;
};

/// Labelled pairs of one scene.
Samples pairs_of(const Pipeline& pipeline, const std::filesystem::path& scene) {
  const Input input = read_scene(scene);
  if (input.ground_truth.empty())
    throw InputError(scene.string() +
                     ": has no ground truth; training needs a label.png, or a cloud with labels, for every scene");
  Samples samples;
  append_pairs(pipeline.perceive(input.frame), input.ground_truth, samples);
  return samples;
}

void print_model(const Model& model, const std::filesystem::path& file) {
  std::cout << file.string() << ": " << model.classifier << " trained on " << model.training.scenes.size()
            << " scenes, " << model.training.positive_pairs << " positive and " << model.training.negative_pairs
            << " negative pairs\n"
            << "value      scaled from\n";
  for (std::size_t i = 0; i < model.names.size(); ++i)
    std::cout << std::left << std::setw(10) << model.names[i] << " [" << model.scaling.low[i] << ", "
              << model.scaling.high[i] << "]\n";
}

int train(const Options& options) {
  const ThreadLimit limit(options.pipeline.threads);
  const std::vector<std::filesystem::path> scenes = find_scenes(options.scenes);
  const LoadedConfig loaded = load_config(options.pipeline);
  const Pipeline pipeline(loaded.config, loaded.registry);

  // A scene that cannot be used ends the training: a model must not silently lack what it was asked to learn.
  std::vector<Samples> by_scene(scenes.size());
  tbb::parallel_for(std::size_t{0}, scenes.size(), [&](std::size_t i) { by_scene[i] = pairs_of(pipeline, scenes[i]); });

  Samples samples;
  TrainingData data;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    samples.columns = pipeline.value_names().size();
    samples.values.insert(samples.values.end(), by_scene[i].values.begin(), by_scene[i].values.end());
    samples.positive.insert(samples.positive.end(), by_scene[i].positive.begin(), by_scene[i].positive.end());
    data.scenes.push_back(scene_name(scenes[i]));
  }
  const Model model = train_model(pipeline.classifier(), loaded.config.classifier.plugin, pipeline.value_names(),
                                  samples, data, config_hash(loaded.config));
  write_model(options.output, model);
  print_model(model, options.output);
  return success;
}

}  // namespace

void add_train(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("train", "Learn from scenes with ground truth which patches belong together");
  command->add_option("scenes", options->scenes, "Scene folders with label.png, or folders of those")
      ->required()
      ->type_name("SCENES");
  command->add_option("--output", options->output, "Model file to write")
      ->check(not_empty)
      ->required()
      ->type_name("MODEL");
  add_pipeline_options(*command, options->pipeline);
  command->footer(
      "Example: gestalt train scenes --output models/mine.json\n"
      "Use it:  gestalt segment INPUT --set structural.model=models/mine.json");
  command->callback([options, &run] { run = [options] { return train(*options); }; });
}

}  // namespace gestalt::app
