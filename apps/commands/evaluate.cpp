// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/score/evaluation.h"

#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "command.h"
#include "gestalt/apps/pipeline_options.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/for_all.h"
#include "gestalt/core/base/output_file.h"
#include "gestalt/core/pipeline/learning_set.h"
#include "gestalt/evaluation/experiment/plot.h"
#include "gestalt/evaluation/score/cross_validation.h"
#include "gestalt/io/scene/input.h"
#include "gestalt/io/scene/png_codec.h"

namespace gestalt::app::evaluate_command {

namespace {

namespace fs = std::filesystem;
using Labels = cv::Mat_<std::uint16_t>;

constexpr const char* labels_image = "labels.png";
constexpr const char* objects_image = "objects.png";

struct Options {
  std::vector<fs::path> scenes;
  PipelineOptions pipeline;
  int folds = 0;  ///< 0: no cross-validation
  std::uint64_t seed = 0;
  std::vector<fs::path> additional;  ///< scenes that every fold also learns from
  fs::path predictions;              ///< empty: run the pipeline
  std::string image{labels_image};   ///< of the results: labels.png or objects.png; of predictions: any name
  bool parts = false;
  fs::path output;  ///< empty: write no label images
  bool json = false;

  RegionKind regions() const { return parts ? RegionKind::parts : RegionKind::objects; }
};

ReliabilityDiagram reliability(const std::map<std::string, PairDecisions>& pairs) {
  ReliabilityDiagram diagram{"Reliability of the probabilities of held-out pairs", {}};
  for (const auto& [level, decisions] : pairs) {
    ReliabilitySeries series{level, {}};
    for (const PairDecisions::Bin& bin : decisions.bins)
      series.bins.push_back({bin.probability / double(bin.pairs), double(bin.positive) / double(bin.pairs), bin.pairs});
    diagram.series.push_back(std::move(series));
  }
  return diagram;
}

/// The scenes with their scores, as far as they have come. An error of one scene does not stop the others.
class Evaluation {
 public:
  explicit Evaluation(const Options& options)
      : scenes(find_scenes(options.scenes)),
        categories(scene_categories(scenes)),
        scores(scenes.size()),
        options_(options),
        failures_(scenes.size()) {}

  const std::vector<fs::path> scenes;
  const std::vector<std::string> categories;
  std::vector<ImageScore> scores;

  bool failed(std::size_t scene) const { return bool(failures_[scene]); }

  /// Calls work(i) for every scene that has not failed, in parallel.
  template <class Work>
  void for_each_scene(const Work& work) {
    for_all(scenes.size(), [&](std::size_t i) {
      if (failed(i)) return;
      try {
        work(i);
      } catch (const OutputError&) {
        throw;
      } catch (const std::exception&) {
        failures_[i] = std::current_exception();
      }
    });
  }

  void score(std::size_t scene, const Labels& ground_truth, const Labels& labels) {
    scores[scene] = score_image(ground_truth, labels, options_.regions());
  }

  void score(std::size_t scene, const Labels& ground_truth, const Segmentation& segmentation) {
    const Labels objects = object_labels(segmentation);
    score(scene, ground_truth, options_.image == objects_image ? objects : segmentation.labels);
    if (options_.output.empty()) return;
    const fs::path folder = options_.output / scene_name(scenes[scene]);
    write_files(
        {{folder / labels_image, encode_png(segmentation.labels)}, {folder / objects_image, encode_png(objects)}});
  }

  /// Prints errors and scores. Throws the first error when no scene could be scored.
  int report(const std::string& method, const std::map<std::string, PairDecisions>& pairs = {}) const {
    std::vector<ImageScore> scored;
    std::vector<std::string> their_categories;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      if (failed(i)) continue;
      scored.push_back(scores[i]);
      their_categories.push_back(categories[i]);
    }
    if (scored.empty()) std::rethrow_exception(failures_.front());
    print_failures();
    const std::vector<ScoreRow> rows = summarise(scored, their_categories);
    if (options_.json) {
      nlohmann::ordered_json json = to_json(rows);
      for (const auto& [level, decisions] : pairs) json["held_out_pairs"][level] = to_json(decisions);
      std::cout << json.dump(1) << '\n';
    } else {
      const std::string all = scored.size() < scenes.size() ? " of " + std::to_string(scenes.size()) : "";
      std::cout << method << ", " << scored.size() << all << " images\n" << format_tables(rows, options_.regions());
      for (const auto& [level, decisions] : pairs) std::cout << format_pairs(decisions, level);
    }
    return scored.size() == scenes.size() ? success : run_failed;
  }

 private:
  void print_failures() const {
    for (const std::exception_ptr& failure : failures_) try {
        if (failure) std::rethrow_exception(failure);
      } catch (const std::exception& error) {
        std::cerr << "gestalt: error: " << error.what() << '\n';
      }
  }

  const Options& options_;
  std::vector<std::exception_ptr> failures_;
};

int score_predictions(const Options& options) {
  if (!fs::is_directory(options.predictions))
    throw InputError(options.predictions.string() + ": is no folder; give the folder that holds the label images");
  Evaluation evaluation(options);
  evaluation.for_each_scene([&](std::size_t i) {
    const Labels ground_truth = read_ground_truth(evaluation.scenes[i]);
    evaluation.score(
        i, ground_truth,
        read_prediction(options.predictions, scene_name(evaluation.scenes[i]), options.image, ground_truth.size()));
  });
  return evaluation.report(options.predictions.string());
}

std::string config_name(const Options& options) {
  return (options.pipeline.config.empty() ? default_config() : options.pipeline.config).filename().string();
}

int score_model(const Options& options) {
  const Segmenter segmenter = load_segmenter(options.pipeline);
  Evaluation evaluation(options);
  evaluation.for_each_scene([&](std::size_t i) {
    const Input input = read_scene(evaluation.scenes[i]);
    const Labels ground_truth = scored_ground_truth(input);
    evaluation.score(i, ground_truth, segmenter.segment(input.frame).segmentation);
  });
  return evaluation.report(config_name(options));
}

LearningScene learning_scene(const Pipeline& pipeline, const fs::path& scene) {
  const Input input = read_scene(scene);
  return make_learning_scene(pipeline, input.frame, scored_ground_truth(input));
}

std::vector<const LearningScene*> pointers(const std::vector<LearningScene>& scenes) {
  std::vector<const LearningScene*> all;
  all.reserve(scenes.size());
  for (const LearningScene& scene : scenes) all.push_back(&scene);
  return all;
}

int cross_validate(const Options& options) {
  const LoadedConfig loaded = load_config(options.pipeline);
  const Pipeline pipeline(loaded.config, loaded.registry);
  Evaluation evaluation(options);
  const std::vector<int> fold = deal_folds(evaluation.categories, options.folds, options.seed);
  // As in training, a scene to learn from that cannot be used ends the run.
  const std::vector<fs::path> additional_scenes =
      options.additional.empty() ? std::vector<fs::path>{} : find_scenes(options.additional);
  std::vector<LearningScene> additional(additional_scenes.size());
  for_all(additional.size(), [&](std::size_t i) { additional[i] = learning_scene(pipeline, additional_scenes[i]); });

  std::vector<LearningScene> perceived(evaluation.scenes.size());
  evaluation.for_each_scene([&](std::size_t i) { perceived[i] = learning_scene(pipeline, evaluation.scenes[i]); });
  std::vector<const LearningScene*> usable = pointers(perceived);
  for (std::size_t i = 0; i < usable.size(); ++i)
    if (evaluation.failed(i)) usable[i] = nullptr;
  const std::vector<Models> models = learn_folds(pipeline, usable, fold, options.folds, pointers(additional));

  LevelDecisions decisions;
  for (std::size_t i = 0; i < perceived.size(); ++i)
    if (usable[i]) count_pairs(pipeline, perceived[i], models[std::size_t(fold[i])], decisions);
  std::map<std::string, PairDecisions> pairs{{name_of(Level::structural), decisions.structural}};
  if (loaded.config.with_assembly) pairs[name_of(Level::assembly)] = decisions.assembly;

  evaluation.for_each_scene([&](std::size_t i) {
    const Labels ground_truth = read_ground_truth(evaluation.scenes[i]);
    evaluation.score(i, ground_truth, pipeline.decide(perceived[i].percept, models[std::size_t(fold[i])]));
  });
  if (!options.output.empty()) write_files({{options.output / "reliability.svg", svg(reliability(pairs))}});
  return evaluation.report(config_name(options) + ", " + std::to_string(options.folds) + "-fold cross-validation",
                           pairs);
}

int evaluate(const Options& options) {
  const ThreadLimit limit(options.pipeline.threads);
  if (!options.predictions.empty()) return score_predictions(options);
  if (options.image != labels_image && options.image != objects_image)
    throw ConfigError("--image " + options.image + ": without --predictions it is labels.png or objects.png");
  return options.folds > 0 ? cross_validate(options) : score_model(options);
}

void add_evaluate(CLI::App& app, Run& run) {
  auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand(
      "evaluate", "Score segmentations against ground truth: of a trained model, cross-validated, or read from files");
  command
      .add_option("scenes", options->scenes,
                  "Scenes with ground truth, or folders of them; FOLDER.csv beside a folder (columns scene and "
                  "category) gives categories")
      ->required()
      ->type_name("SCENES");
  command.footer("Example: gestalt evaluate scenes --cross-validate 5");
  add_pipeline_options(command, options->pipeline);
  CLI::Option* predictions =
      command
          .add_option("--predictions", options->predictions,
                      "Score the label images DIR/<scene>/labels.png (or --image) or DIR/<scene>.png and run nothing")
          ->type_name("DIR");
  command
      .add_option(
          "--image", options->image,
          "Which result to score: labels.png, or objects.png, where background is 0; with --predictions any file's "
          "name")
      ->type_name("FILE");
  CLI::Option* folds = command
                           .add_option("--cross-validate", options->folds,
                                       "Segment each of K folds of the scenes with a model trained on the others")
                           ->check(CLI::Range(2, 1000000))
                           ->excludes(predictions)
                           ->type_name("K");
  command.add_option("--seed", options->seed, "Deal the scenes to the folds in this random order; 0: in natural order")
      ->needs(folds)
      ->type_name("S");
  command
      .add_option("--also-train", options->additional,
                  "Scenes that every fold's model also learns from, such as synthetic ones; they are not scored")
      ->needs(folds)
      ->type_name("SCENES");
  command.add_flag("--parts", options->parts, "Regions are the visible parts of objects, not whole objects");
  command
      .add_option("--output", options->output,
                  "Also write DIR/<scene>/labels.png and objects.png, and with --cross-validate "
                  "the diagram DIR/reliability.svg")
      ->check(not_empty)
      ->excludes(predictions)
      ->type_name("DIR");
  command.add_flag("--json", options->json, "Print every value as a fraction, for programs");
  command.callback([options, &run] { run = [options] { return evaluate(*options); }; });
}

const Subcommand subcommand(40, add_evaluate);

}  // namespace

}  // namespace gestalt::app::evaluate_command
