// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/experiment/experiment.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <set>

#include "gestalt/core/base/digest.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/for_all.h"
#include "gestalt/evaluation/score/feature_score.h"
#include "gestalt/io/scene/input.h"
#include "result_file.h"
#include "scene_set.h"
#include "shared_features.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

using Labels = cv::Mat_<std::uint16_t>;

/// The scenes with what a group of variants shares of them.
struct SharedScenes {
  const SceneSet& set;
  std::vector<LearningScene> perceived;
  std::vector<Labels> ground_truth;
};

/// What a variant gives for one scene.
struct SceneOutcome {
  ImageScore score;  // of scored scenes
  LevelDecisions decisions;
  Samples structural, assembly;  // labelled pairs
  CategoryCount count;
};

SceneOutcome evaluate_scene(const Pipeline& pipeline, const Models& models, const SceneUse& use,
                            const LearningScene& scene, const Labels& ground_truth) {
  SceneOutcome outcome;
  outcome.structural = labelled_pairs(scene.percept.structural, scene.objects);
  outcome.count = {use.category, 1, count_objects(ground_truth)};
  outcome.count.structural_pairs = std::int64_t(scene.percept.structural.pairs.size());
  outcome.count.structural_same = std::count(outcome.structural.positive.begin(), outcome.structural.positive.end(), 1);
  if (models.assembly) {
    const std::vector<int> groups = pipeline.structural_groups(scene.percept, models.structural);
    outcome.assembly = assembly_pairs(scene, groups);
    outcome.count.assembly_same = std::count(outcome.assembly.positive.begin(), outcome.assembly.positive.end(), 1);
    outcome.count.assembly_pairs = std::int64_t(assembly_rows(scene.percept, groups).size());
  }
  if (use.scored) {
    count_pairs(pipeline, scene, models, outcome.decisions);
    outcome.score = score_image(ground_truth, pipeline.decide(scene.percept, models).labels);
  }
  return outcome;
}

/// Sums by category, in order of first appearance, and of all; a scene of no category counts in "all" only.
std::vector<CategoryCount> sum_counts(const std::vector<CategoryCount>& counts) {
  std::vector<CategoryCount> rows;
  CategoryCount all{"all"};
  const auto add = [](CategoryCount& sum, const CategoryCount& count) {
    sum.images += count.images;
    sum.objects += count.objects;
    sum.structural_pairs += count.structural_pairs;
    sum.structural_same += count.structural_same;
    sum.assembly_pairs += count.assembly_pairs;
    sum.assembly_same += count.assembly_same;
  };
  for (const CategoryCount& count : counts) {
    add(all, count);
    if (count.category.empty()) continue;
    auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.category == count.category; });
    if (row == rows.end()) row = rows.insert(rows.end(), {count.category});
    add(*row, count);
  }
  if (!counts.empty()) rows.push_back(all);
  return rows;
}

void add(PairErrors& sum, const PairDecisions& decisions) {
  sum.positive += decisions.true_positive + decisions.false_negative;
  sum.negative += decisions.true_negative + decisions.false_positive;
}

PairDecisions& operator+=(PairDecisions& sum, const PairDecisions& more) {
  sum.true_positive += more.true_positive;
  sum.false_positive += more.false_positive;
  sum.true_negative += more.true_negative;
  sum.false_negative += more.false_negative;
  return sum;
}

PairErrors errors_of(const PairDecisions& decisions) {
  PairErrors errors;
  add(errors, decisions);
  errors.balanced_error = decisions.balanced_error();
  return errors;
}

std::vector<ValueScore> value_scores(const std::vector<std::string>& names, const Samples& samples) {
  const std::vector<double> scores = feature_scores(samples);
  std::vector<ValueScore> values;
  for (std::size_t i = 0; i < names.size(); ++i) values.push_back({names[i], scores.at(i)});
  return values;
}

ExperimentResult summarise_outcomes(const std::vector<SceneUse>& uses, const std::vector<LearningScene>& scenes,
                                    const std::vector<SceneOutcome>& outcomes, bool with_assembly) {
  ExperimentResult result;
  std::vector<ImageScore> scores, further_scores;
  std::vector<std::string> categories, further_sets;
  std::vector<CategoryCount> learn, test;
  LevelDecisions decisions;
  Samples structural, assembly;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const SceneUse& use = uses[i];
    const SceneOutcome& outcome = outcomes[i];
    if (use.further >= 0) {
      further_scores.push_back(outcome.score);
      further_sets.push_back(use.category);
      continue;
    }
    (use.learnt ? learn : test).push_back(outcome.count);
    if (use.learnt) {
      structural.append(outcome.structural);
      assembly.append(outcome.assembly);
    }
    if (!use.scored) continue;
    scores.push_back(outcome.score);
    categories.push_back(use.category);
    decisions.structural += outcome.decisions.structural;
    decisions.assembly += outcome.decisions.assembly;
    for (const PooledPixels& object : outcome.score.each)
      result.objects.push_back({use.name, use.category, object.precision(), object.recall()});
  }
  result.scores = category_scores(scores, categories);
  result.structural = errors_of(decisions.structural);
  result.assembly = errors_of(decisions.assembly);
  result.structural_values = value_scores(scenes.front().percept.structural.names, structural);
  if (with_assembly) result.assembly_values = value_scores(scenes.front().percept.assembly.names, assembly);
  result.learn = sum_counts(learn);
  result.test = sum_counts(test);
  result.further = category_scores(further_scores, further_sets);
  result.further.pop_back();  // the row of all
  return result;
}

std::vector<Models> train(const Pipeline& pipeline, const SceneSet& set, const std::vector<LearningScene>& scenes) {
  std::vector<const LearningScene*> learnt;
  for (std::size_t i = 0; i < scenes.size(); ++i)
    if (set.scenes[i].learnt) learnt.push_back(&scenes[i]);
  std::vector<Models> models;
  if (set.folds > 0) models = learn_folds(pipeline, learnt, set.fold, set.folds);
  const bool use_all = std::any_of(set.scenes.begin(), set.scenes.end(),
                                   [&](const SceneUse& scene) { return std::size_t(scene.model) == models.size(); });
  if (use_all) models.push_back(learn(pipeline, learnt));
  return models;
}

ExperimentResult run_variant(const Variant& variant, const Registry& registry, const SharedFeatures& features,
                             const SharedScenes& shared) {
  const Pipeline pipeline(variant.config, registry);
  const std::size_t count = shared.perceived.size();
  std::vector<LearningScene> scenes(count);
  for_all(count, [&](std::size_t i) { scenes[i] = features.scene_for(variant, shared.perceived[i]); });
  const std::vector<Models> models = train(pipeline, shared.set, scenes);
  std::vector<SceneOutcome> outcomes(count);
  for_all(count, [&](std::size_t i) {
    const SceneUse& use = shared.set.scenes[i];
    outcomes[i] = evaluate_scene(pipeline, models[std::size_t(use.model)], use, scenes[i], shared.ground_truth[i]);
  });
  return summarise_outcomes(shared.set.scenes, scenes, outcomes, variant.config.with_assembly);
}

/// The files of the program, of the core and of the plugins of a config. They are read each once.
class Programs {
 public:
  explicit Programs(const Registry& registry) : registry_(registry) {}

  std::string text(const Config& config) {
    std::set<fs::path> files{fs::canonical("/proc/self/exe"), core_library()};
    const auto add = [&](const char* kind, const ComponentConfig& component) {
      if (const ComponentInfo* info = registry_.find(kind, component.plugin)) files.insert(info->library);
    };
    add("clusterer", config.clusterer);
    for (const ComponentConfig& fitter : config.fitters) add("fitter", fitter);
    add_level(config.structural, add);
    if (config.with_assembly) add_level(*config.assembly, add);
    add("solver", config.solver);

    std::string text = "gestalt " GESTALT_VERSION " " + build_fingerprint() + "\n";
    for (const fs::path& file : files) {
      if (!hashes_.contains(file)) hashes_[file] = file_digest(file);
      text += file.filename().string() + " " + hashes_[file] + "\n";
    }
    return text;
  }

 private:
  static void add_level(const LevelConfig& level, const auto& add) {
    for (const ComponentConfig& relation : level.relations) add("relation", relation);
    add("classifier", level.classifier);
  }

  const Registry& registry_;
  std::map<fs::path, std::string> hashes_;
};

/// Reports progress and warnings one at a time.
class Reporter {
 public:
  Reporter(const ExperimentEvents& events, std::size_t total) : events_(events), total_(total) {}

  void finished(const std::string& variant) {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (events_.progress) events_.progress(done_, total_, variant);
  }

  /// Each once: scenes are read for every group of variants.
  void warn(const std::vector<std::string>& warnings) {
    const std::lock_guard lock(mutex_);
    for (const std::string& warning : warnings)
      if (events_.warning && warned_.insert(warning).second) events_.warning(warning);
  }

 private:
  const ExperimentEvents& events_;
  const std::size_t total_;
  std::set<std::string> warned_;
  std::size_t done_ = 0;
  std::mutex mutex_;
};

SharedScenes perceive(const SharedFeatures& features, const SceneSet& set, Reporter& reporter) {
  SharedScenes shared{set, std::vector<LearningScene>(set.scenes.size()), std::vector<Labels>(set.scenes.size())};
  std::atomic<std::int64_t> objects = 0;
  for_all(set.scenes.size(), [&](std::size_t i) {
    const Input input = read_scene(set.scenes[i].path, set.read);
    reporter.warn(input.warnings);
    shared.ground_truth[i] = scored_ground_truth(input);
    shared.perceived[i] = features.perceive(input.frame, shared.ground_truth[i]);
    if (set.scenes[i].scored) objects += count_objects(shared.ground_truth[i]);
  });
  require_objects(objects);
  return shared;
}

/// A variant that has to be computed.
struct Task {
  const Variant* variant;
  ResultFile file;
  ExperimentOutcome* outcome;
};

/// Computes variants with equal surfaces.
void run_group(const std::vector<Task*>& tasks, const Registry& registry, const SceneSet& set, Reporter& reporter) {
  std::vector<const Variant*> variants;
  variants.reserve(tasks.size());
  for (const Task* task : tasks) variants.push_back(task->variant);
  const SharedFeatures features(variants, registry);
  const SharedScenes shared = perceive(features, set, reporter);
  for_all(tasks.size(), [&](std::size_t i) {
    // A thread that waits inside one variant must not start another: each holds a copy of all scenes.
    tbb::this_task_arena::isolate([&] {
      const auto& [variant, file, outcome] = *tasks[i];
      try {
        outcome->result = run_variant(*variant, registry, features, shared);
      } catch (const InputError&) {
        throw;
      } catch (const Error&) {
        outcome->failure = std::current_exception();
      }
      if (outcome->result) file.write(*outcome->result);
      reporter.finished(variant->name);
    });
  });
}

}  // namespace

std::vector<CategoryScore> category_scores(const std::vector<ImageScore>& scores,
                                           const std::vector<std::string>& categories) {
  std::vector<CategoryScore> rows;
  for (const ScoreRow& row : summarise(scores, categories)) {
    const OverlapBoundary& values = row.overlap_boundary[std::size_t(BackgroundRule::table)];
    rows.push_back({row.category, row.images, row.regions, row.precision, row.recall, values.overlap_f,
                    values.boundary_f, values.detected});
  }
  return rows;
}

std::vector<ExperimentOutcome> run_experiments(const std::vector<Variant>& variants, const Registry& registry,
                                               const Protocol& protocol, const OutputPath& store,
                                               const ExperimentEvents& events) {
  const SceneSet set(protocol);
  const std::string scenes = canonical(set);
  Programs programs(registry);
  Reporter reporter(events, variants.size());

  std::vector<ExperimentOutcome> outcomes(variants.size());
  std::map<std::string, std::size_t> first;  // variant of each key
  std::vector<std::size_t> same_as(variants.size());
  std::vector<Task> tasks;
  tasks.reserve(variants.size());
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const Variant& variant = variants[i];
    const std::string key = programs.text(variant.config) + canonical(variant.config) + scenes;
    same_as[i] = first.emplace(key, i).first->second;
    if (same_as[i] != i) continue;
    ResultFile file(store, key);
    outcomes[i].result = file.read(events.warning);
    if (outcomes[i].result)
      reporter.finished(variant.name);
    else
      tasks.push_back({&variant, std::move(file), &outcomes[i]});
  }

  std::vector<std::string> order;
  std::map<std::string, std::vector<Task*>> groups;
  for (Task& task : tasks) {
    const std::string surfaces = canonical_surfaces(task.variant->config);
    if (!groups.contains(surfaces)) order.push_back(surfaces);
    groups[surfaces].push_back(&task);
  }
  for (const std::string& surfaces : order) run_group(groups[surfaces], registry, set, reporter);
  for (std::size_t i = 0; i < variants.size(); ++i) {
    if (same_as[i] == i) continue;
    outcomes[i] = outcomes[same_as[i]];
    reporter.finished(variants[i].name);
  }
  return outcomes;
}

}  // namespace gestalt
