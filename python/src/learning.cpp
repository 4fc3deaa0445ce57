// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "arguments.h"
#include "arrays.h"
#include "components.h"
#include "core_call.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/for_all.h"
#include "gestalt/core/pipeline/learning_set.h"
#include "gestalt/evaluation/score/cross_validation.h"
#include "gestalt/evaluation/score/evaluation.h"
#include "gestalt/evaluation/score/scene_sets.h"
#include "gestalt/io/scene/depth_only.h"
#include "gestalt/io/scene/input.h"
#include "segmenter.h"
#include "wording.h"

namespace gestalt::python {

namespace {

namespace fs = std::filesystem;
using Labels = cv::Mat_<std::uint16_t>;

/// Labelled scenes as learning and scoring need them.
struct PerceivedScenes {
  std::vector<LearningScene> scenes;
  std::vector<Labels> ground_truth;
  std::vector<std::vector<std::string>> warnings;

  std::vector<const LearningScene*> pointers() const {
    std::vector<const LearningScene*> all;
    for (const LearningScene& scene : scenes) all.push_back(&scene);
    return all;
  }

  std::int64_t objects() const {
    std::int64_t sum = 0;
    for (const Labels& labels : ground_truth) sum += count_objects(labels);
    return sum;
  }
};

/// A pipeline for scenes that are learnt from together.
class Learner {
 public:
  Learner(const py::object& config, const std::vector<std::string>& overrides, const py::object& components,
          const std::vector<fs::path>& scenes, const ReadOptions& options, const Arena& arena)
      : options_(options),
        arena_(arena),
        loaded_(load(config, overrides, components, scenes)),
        pipeline_(arena.run([&] { return Pipeline(loaded_.config, loaded_.registry); })) {}

  const Pipeline& pipeline() const { return pipeline_; }

  /// Warns of what the scenes are probably not.
  PerceivedScenes perceive(const std::vector<fs::path>& scenes) const {
    PerceivedScenes perceived{std::vector<LearningScene>(scenes.size()), std::vector<Labels>(scenes.size()),
                              std::vector<std::vector<std::string>>(scenes.size())};
    arena_.run([&] {
      for_all(scenes.size(), [&](std::size_t i) {
        require_interpreter();
        const Input input = read_scene(scenes[i], options_);
        if (needs_colour_) require_colour_as_of_others(input);
        perceived.warnings[i] = input.warnings;
        perceived.ground_truth[i] = scored_ground_truth(input);
        perceived.scenes[i] = make_learning_scene(pipeline_, input.frame, input.ground_truth);
      });
    });
    for (const std::vector<std::string>& of_scene : perceived.warnings) warn(of_scene);
    return perceived;
  }

 private:
  LoadedConfig load(const py::object& config, const std::vector<std::string>& overrides, const py::object& components,
                    const std::vector<fs::path>& scenes) {
    const py::object chosen = config_for_all(config, overrides, scenes, options_, arena_);
    needs_colour_ = chosen.is_none() && depth_only_may_replace({}, overrides);
    return load_config(chosen, overrides, registered(components));
  }

  const ReadOptions& options_;
  const Arena& arena_;
  bool needs_colour_ = false;  ///< the config is the default, by which all scenes are learnt or none
  LoadedConfig loaded_;
  Pipeline pipeline_;
};

nlohmann::json training_of(const Model& model) {
  return {{"classifier", model.classifier},
          {"values", model.names},
          {"scenes", model.training.scenes.size()},
          {"positive_pairs", model.training.positive_pairs},
          {"negative_pairs", model.training.negative_pairs}};
}

py::object train(const py::object& scenes, const fs::path& output, const py::object& config,
                 const py::object& overrides, const py::object& components, int threads,
                 std::optional<double> depth_scale, const std::optional<std::string>& depth_kind,
                 const std::optional<std::string>& labels) {
  const std::vector<fs::path> given = some_paths(scenes);
  const ReadOptions options = read_options({{}, depth_scale, depth_kind, labels});
  const Arena arena(threads);
  const std::vector<fs::path> all = arena.run([&] { return find_scenes(given); });
  const Learner learner(config, override_texts(overrides), components, all, options, arena);
  const PerceivedScenes perceived = learner.perceive(all);
  require_objects(perceived.objects());
  return object_of(arena.run([&] {
    const Models models = learn(learner.pipeline(), perceived.pointers());
    write_models(output, models);
    nlohmann::json trained{{name_of(Level::structural), training_of(models.structural)}};
    if (models.assembly) trained[name_of(Level::assembly)] = training_of(*models.assembly);
    return trained;
  }));
}

py::object cross_validate(const py::object& scenes, int folds, std::uint64_t seed, const py::object& config,
                          const py::object& overrides, const std::optional<std::string>& left_out,
                          const py::object& also_train, const py::object& components, int threads,
                          std::optional<double> depth_scale, const std::optional<std::string>& depth_kind,
                          const std::optional<std::string>& labels) {
  const ReadOptions options = read_options({{}, depth_scale, depth_kind, labels});
  const std::vector<fs::path> given = some_paths(scenes), others = paths(also_train);
  const Arena arena(threads);
  const std::vector<fs::path> all = arena.run([&] { return find_scenes(given); });
  std::vector<int> fold;
  int count = folds;
  if (left_out) {
    const LeaveOneOut dealt = leave_one_out(all, left_out_named(*left_out));
    fold = dealt.fold;
    count = dealt.folds();
  } else {
    fold = deal_folds(scene_categories(all), folds, seed);
  }
  const std::vector<fs::path> more = find_additional_scenes(others, all);
  const Learner learner(config, override_texts(overrides), components, all, options, arena);
  const PerceivedScenes perceived = learner.perceive(all), additional = learner.perceive(more);
  require_objects(perceived.objects());
  return object_of(arena.run([&] {
    const Pipeline& pipeline = learner.pipeline();
    const std::vector<Models> models = learn_folds(pipeline, perceived.pointers(), fold, count, additional.pointers());
    std::vector<ImageScore> scores(all.size());
    for_all(all.size(), [&](std::size_t i) {
      require_interpreter();
      const Models& theirs = models[std::size_t(fold[i])];
      scores[i] = score_image(perceived.ground_truth[i], pipeline.decide(perceived.scenes[i].percept, theirs).labels);
    });
    return to_json(with_mean(summarise(scores, scene_rows(all))));
  }));
}

Labels label_image(const py::array& labels, const char* name) {
  refuse_mask(labels, name);
  if (labels.ndim() != 2 || (labels.dtype().kind() != 'u' && labels.dtype().kind() != 'i'))
    throw InputError(std::string(name) + ": expected integers of shape (height, width)");
  const py::array_t<std::int64_t, py::array::c_style | py::array::forcecast> rows(labels);
  Labels image(int(rows.shape(0)), int(rows.shape(1)));
  for (py::ssize_t v = 0; v < rows.shape(0); ++v)
    for (py::ssize_t u = 0; u < rows.shape(1); ++u) {
      const std::int64_t label = rows.at(v, u);
      if (label < 0 || label > 65535)
        throw InputError(std::string(name) + ": label " + std::to_string(label) + " is not in [0, 65535]");
      image(int(v), int(u)) = std::uint16_t(label);
    }
  return image;
}

py::object score(const py::array& ground_truth, const py::array& labels) {
  const Labels truth = label_image(ground_truth, "ground_truth"), found = label_image(labels, "labels");
  if (truth.size() != found.size()) throw InputError("ground_truth and labels differ in size");
  return object_of(to_json(summarise({score_image(truth, found)}, {"all"})))["all"];
}

}  // namespace

void bind_learning(py::module_& module) {
  module.def("train", &train, Computing(), py::arg("scenes"), py::arg("output"), py::arg("config") = py::none(),
             py::arg("overrides") = py::tuple(), py::kw_only(), py::arg("components") = py::none(),
             py::arg("threads") = 0, py::arg("depth_scale") = py::none(), py::arg("depth_kind") = py::none(),
             py::arg("labels") = py::none(),
             R"(Learns from scenes with ground truth and writes the model file output.

scenes: folders of scenes, one or many. labels: the meaning of their ground truth, "osd", "objects" or "colours";
None: inferred if unambiguous. If no scene has colour and no config is given, depth_only.yaml is used, with a warning.
Returns the classifier, the values and the number of training pairs of each level. Use the model with the same config
and overrides={"model": ...}. Also raises InputError if no scene has an object.)");
  module.def("cross_validate", &cross_validate, Computing(), py::arg("scenes"), py::arg("folds") = 5,
             py::arg("seed") = 0, py::arg("config") = py::none(), py::arg("overrides") = py::tuple(), py::kw_only(),
             py::arg("leave_one_out") = py::none(), py::arg("also_train") = py::tuple(),
             py::arg("components") = py::none(), py::arg("threads") = 0, py::arg("depth_scale") = py::none(),
             py::arg("depth_kind") = py::none(), py::arg("labels") = py::none(),
             R"(Trains on all folds of the scenes but one and scores that one, for each.

leave_one_out: "category" or "set", each of which is then a fold; folds and seed do not count. also_train: scenes that
every fold learns from and that are not scored. Returns the scores of each category (of several sets SET/CATEGORY),
their "mean", and of "all", as `gestalt evaluate --cross-validate N --json` prints them.)");
  module.def("score", &score, Computing(), py::arg("ground_truth"), py::arg("labels"),
             "Scores of one label image against ground truth, where that has 0 for pixels without depth.");
}

}  // namespace gestalt::python
