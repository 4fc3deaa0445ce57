// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/score/evaluation.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "command.h"
#include "gestalt/apps/depth_only.h"
#include "gestalt/apps/number_in.h"
#include "gestalt/apps/pipeline_options.h"
#include "gestalt/apps/reading_options.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/for_all.h"
#include "gestalt/core/base/output_file.h"
#include "gestalt/core/pipeline/learning_set.h"
#include "gestalt/evaluation/experiment/plot.h"
#include "gestalt/evaluation/score/cross_validation.h"
#include "gestalt/evaluation/score/scene_sets.h"
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
  ReadingOptions reading;
  PipelineOptions pipeline;
  int folds = 0;         ///< 0: no cross-validation
  std::string left_out;  ///< of left_out_names; empty: no such cross-validation
  std::uint64_t seed = 0;
  std::vector<fs::path> additional;  ///< scenes that every fold also learns from
  fs::path predictions;              ///< empty: run the pipeline
  std::string image{labels_image};   ///< of the results: labels.png or objects.png; of predictions: any name
  std::string rule;                  ///< of background_rule_names; empty: what suits the image
  bool parts = false;
  bool all = false;
  fs::path output;  ///< empty: write no label images
  bool json = false;

  RegionKind regions() const { return parts ? RegionKind::parts : RegionKind::objects; }
  BackgroundRule background() const;
};

BackgroundRule Options::background() const {
  const auto found = std::find(background_rule_names.begin(), background_rule_names.end(), rule);
  if (found != background_rule_names.end()) return BackgroundRule(found - background_rule_names.begin());
  // In the image of objects the method has told itself what is background.
  return image == objects_image ? BackgroundRule::none : BackgroundRule::majority;
}

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
        rows(scene_rows(scenes)),
        scores(scenes.size()),
        options_(options),
        failures_(scenes.size()) {}

  const std::vector<fs::path> scenes;
  const std::vector<std::string> rows;  ///< of each scene
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
    objects_ += count_objects(ground_truth);
  }

  void score(std::size_t scene, const Labels& ground_truth, const Segmentation& segmentation) {
    const Labels objects = object_labels(segmentation);
    score(scene, ground_truth, options_.image == objects_image ? objects : segmentation.labels);
    if (options_.output.empty()) return;
    const OutputPath folder = OutputPath(options_.output) / scene_name(scenes[scene]);
    write_files(
        {{folder / labels_image, encode_png(segmentation.labels)}, {folder / objects_image, encode_png(objects)}});
  }

  /// Prints errors and scores. Throws the first error when no scene could be scored.
  int report(const std::string& method, const std::map<std::string, PairDecisions>& pairs = {}) const {
    std::vector<ImageScore> scored;
    std::vector<std::string> their_rows;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      if (failed(i)) continue;
      scored.push_back(scores[i]);
      their_rows.push_back(rows[i]);
    }
    if (scored.empty()) std::rethrow_exception(failures_.front());
    print_failures();
    require_objects(objects_);
    const std::vector<ScoreRow> table = with_mean(summarise(scored, their_rows));
    if (options_.json) {
      print_json(table, pairs);
    } else {
      const std::string all = scored.size() < scenes.size() ? " of " + std::to_string(scenes.size()) : "";
      std::cout << method << ", " << scored.size() << all << " images\n";
      print_tables(table, pairs);
    }
    return scored.size() == scenes.size() ? success : run_failed;
  }

 private:
  void print_tables(const std::vector<ScoreRow>& table, const std::map<std::string, PairDecisions>& pairs) const {
    const BackgroundRule rule = options_.background();
    std::cout << options_.image << " scored under the rule " << background_rule_names[std::size_t(rule)] << ": "
              << meaning(rule) << '\n'
              << format_tables(table, options_.regions(), rule);
    if (!options_.all) return;
    std::cout << format_other_tables(table, options_.regions());
    for (const auto& [level, decisions] : pairs) std::cout << format_pairs(decisions, level);
  }

  void print_json(const std::vector<ScoreRow>& table, const std::map<std::string, PairDecisions>& pairs) const {
    nlohmann::ordered_json json = to_json(table);
    json["scored"] = {{"image", options_.image},
                      {"regions", options_.parts ? "parts" : "objects"},
                      {"rule", background_rule_names[std::size_t(options_.background())]}};
    for (const auto& [level, decisions] : pairs) json["held_out_pairs"][level] = to_json(decisions);
    std::cout << json.dump(1) << '\n';
  }

  void print_failures() const {
    for (const std::exception_ptr& failure : failures_) try {
        if (failure) std::rethrow_exception(failure);
      } catch (const std::exception& error) {
        std::cerr << "gestalt: error: " << error.what() << '\n';
      }
  }

  const Options& options_;
  std::vector<std::exception_ptr> failures_;
  std::atomic<std::int64_t> objects_ = 0;  ///< of all ground truth
};

int score_predictions(const Options& options) {
  if (!fs::is_directory(options.predictions))
    throw InputError(options.predictions.string() + ": is not a folder; give the folder that holds the label images");
  const ReadOptions read = read_options(options.reading);
  Evaluation evaluation(options);
  evaluation.for_each_scene([&](std::size_t i) {
    const Labels ground_truth = read_ground_truth(evaluation.scenes[i], read);
    evaluation.score(
        i, ground_truth,
        read_prediction(options.predictions, scene_name(evaluation.scenes[i]), options.image, ground_truth.size()));
  });
  return evaluation.report(options.predictions.string());
}

std::string config_name(const PipelineOptions& options) {
  return (options.config.empty() ? default_config() : options.config).filename().string();
}

int score_model(const Options& options) {
  const ReadOptions read = read_options(options.reading);
  Evaluation evaluation(options);
  const PipelineOptions pipeline = options_for_all(options.pipeline, evaluation.scenes, read, " and its model");
  const Segmenter segmenter = load_segmenter(pipeline);
  evaluation.for_each_scene([&](std::size_t i) {
    const Input input = read_one_of_many(evaluation.scenes[i], read, pipeline);
    const Labels ground_truth = scored_ground_truth(input);
    evaluation.score(i, ground_truth, segmenter.segment(input.frame).segmentation);
  });
  return evaluation.report(config_name(pipeline));
}

std::vector<const LearningScene*> pointers(const std::vector<LearningScene>& scenes) {
  std::vector<const LearningScene*> all;
  all.reserve(scenes.size());
  for (const LearningScene& scene : scenes) all.push_back(&scene);
  return all;
}

/// Scenes whose models are trained on those of all other folds.
struct Folds {
  std::vector<int> fold;  ///< of each scene
  int count;
  std::string method;
};

Folds deal(const Options& options, const std::vector<fs::path>& scenes) {
  if (options.left_out.empty())
    return {deal_folds(scene_categories(scenes), options.folds, options.seed), options.folds,
            std::to_string(options.folds) + "-fold cross-validation"};
  const LeaveOneOut dealt = leave_one_out(scenes, left_out_named(options.left_out));
  const std::string count = std::to_string(dealt.folds());
  return {dealt.fold, dealt.folds(), "each " + options.left_out + " of " + count + " left out of training"};
}

int cross_validate(const Options& options) {
  const ReadOptions read = read_options(options.reading);
  Evaluation evaluation(options);
  const PipelineOptions chosen = options_for_all(options.pipeline, evaluation.scenes, read);
  const LoadedConfig loaded = load_config(chosen);
  const Pipeline pipeline(loaded.config, loaded.registry);
  const auto learning_scene = [&](const fs::path& scene) {
    const Input input = read_one_of_many(scene, read, chosen);
    return make_learning_scene(pipeline, input.frame, scored_ground_truth(input));
  };
  const Folds folds = deal(options, evaluation.scenes);
  // As in training, a scene to learn from that cannot be used ends the run.
  const std::vector<fs::path> others = find_additional_scenes(options.additional, evaluation.scenes);
  std::vector<LearningScene> additional(others.size());
  for_all(additional.size(), [&](std::size_t i) { additional[i] = learning_scene(others[i]); });

  std::vector<LearningScene> perceived(evaluation.scenes.size());
  evaluation.for_each_scene([&](std::size_t i) { perceived[i] = learning_scene(evaluation.scenes[i]); });
  std::vector<const LearningScene*> usable = pointers(perceived);
  for (std::size_t i = 0; i < usable.size(); ++i)
    if (evaluation.failed(i)) usable[i] = nullptr;
  const std::vector<Models> models = learn_folds(pipeline, usable, folds.fold, folds.count, pointers(additional));
  const auto models_of = [&](std::size_t scene) -> const Models& { return models[std::size_t(folds.fold[scene])]; };

  LevelDecisions decisions;
  for (std::size_t i = 0; i < perceived.size(); ++i)
    if (usable[i]) count_pairs(pipeline, perceived[i], models_of(i), decisions);
  std::map<std::string, PairDecisions> pairs{{name_of(Level::structural), decisions.structural}};
  if (loaded.config.with_assembly) pairs[name_of(Level::assembly)] = decisions.assembly;

  evaluation.for_each_scene([&](std::size_t i) {
    const Labels ground_truth = read_ground_truth(evaluation.scenes[i], read);
    evaluation.score(i, ground_truth, pipeline.decide(perceived[i].percept, models_of(i)));
  });
  if (!options.output.empty()) write_files({{OutputPath(options.output) / "reliability.svg", svg(reliability(pairs))}});
  return evaluation.report(config_name(chosen) + ", " + folds.method, pairs);
}

/// The labels of an evaluation would lie among results of another run.
void require_no_results(const Options& options) {
  if (options.output.empty()) return;
  for (const fs::path& scene : find_scenes(options.scenes)) {
    const fs::path result = options.output / scene_name(scene) / "result.json";
    std::error_code ignored;
    if (fs::exists(result, ignored))
      throw ConfigError(result.string() +
                        ": would not belong to the labels that are written beside it; choose another " + "--output");
  }
}

int evaluate(const Options& options) {
  const ThreadLimit limit(options.pipeline.threads);
  require_no_results(options);
  if (!options.predictions.empty()) return score_predictions(options);
  if (options.image != labels_image && options.image != objects_image)
    throw ConfigError("--image " + options.image + ": without --predictions it is labels.png or objects.png");
  const bool held_out = options.folds > 0 || !options.left_out.empty();
  if (!options.additional.empty() && !held_out)
    throw ConfigError("--also-train: nothing is trained; add --cross-validate K or --leave-one-out category");
  return held_out ? cross_validate(options) : score_model(options);
}

template <std::size_t n>
std::vector<std::string> names(const std::array<std::string_view, n>& of) {
  return {of.begin(), of.end()};
}

void add_evaluate(CLI::App& app, Run& run) {
  auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand(
      "evaluate", "Score segmentations against ground truth: of a trained model, cross-validated, or read from files");
  command
      .add_option("scenes", options->scenes,
                  "Scenes with ground truth, or sets: folders of them; FOLDER.csv beside a folder (columns scene and "
                  "category) gives categories")
      ->required()
      ->type_name("SCENES");
  command.footer(
      "Examples: gestalt evaluate scenes --cross-validate 5\n"
      "          gestalt evaluate ours theirs --leave-one-out set");
  add_reading_options(command, options->reading);
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
                           ->check(number_in(2, 1000000))
                           ->excludes(predictions)
                           ->type_name("K");
  command
      .add_option("--leave-one-out", options->left_out,
                  "Segment each category, or each set, with a model trained on all others")
      ->check(CLI::IsMember(names(left_out_names)))
      ->excludes(predictions)
      ->excludes(folds)
      ->type_name("WHAT");
  command
      .add_option("--seed", options->seed,
                  "Seed of the random order in which scenes are assigned to folds; 0: natural order")
      ->check(seed_number())
      ->needs(folds)
      ->type_name("S");
  command
      .add_option("--also-train", options->additional,
                  "Scenes that the models of --cross-validate and --leave-one-out also learn from, such as synthetic "
                  "ones; they are not scored")
      ->excludes(predictions)
      ->type_name("SCENES");
  command
      .add_option("--rule", options->rule,
                  "Which segments the first table treats as background (default: majority; none for objects.png)")
      ->check(CLI::IsMember(names(background_rule_names)))
      ->type_name("RULE");
  command.add_flag("--parts", options->parts, "Regions are the visible parts of objects, not whole objects");
  command.add_flag("--all", options->all, "Also print the tables of every rule, of parts and of held-out pairs");
  command
      .add_option("--output", options->output,
                  "Also write DIR/<scene>/labels.png and objects.png, and where models are "
                  "trained the diagram DIR/reliability.svg")
      ->excludes(predictions)
      ->type_name("DIR");
  command.add_flag("--json", options->json, "Print every value as a fraction, for programs");
  command.callback([options, &run] { run = [options] { return evaluate(*options); }; });
}

const Subcommand subcommand(40, add_evaluate);

}  // namespace

}  // namespace gestalt::app::evaluate_command
