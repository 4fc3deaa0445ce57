// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/pipeline/model.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/json_file.h"
#include "gestalt/core/base/output_file.h"
#include "gestalt/core/pipeline/model_fields.h"
#include "gestalt/core/plugin/component_call.h"

namespace gestalt {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr const char* format = "gestalt-model";
constexpr int version = 2;

const char* const retrain = "retrain it with `gestalt train`";

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// Those of a that are not in b, in order.
std::vector<std::string> without(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  std::vector<std::string> rest;
  std::copy_if(a.begin(), a.end(), std::back_inserter(rest),
               [&](const std::string& name) { return std::find(b.begin(), b.end(), name) == b.end(); });
  return rest;
}

/// How the relation values of a model differ from those of a config, or "".
std::string difference(const std::vector<std::string>& of_model, const std::vector<std::string>& of_config) {
  if (of_model == of_config) return "";
  std::string text;
  if (const auto missing = without(of_model, of_config); !missing.empty())
    text += "; the config lacks " + joined(missing);
  if (const auto extra = without(of_config, of_model); !extra.empty()) text += "; the model lacks " + joined(extra);
  if (text.empty()) text = "; the order differs: the config has " + joined(of_config);
  return text;
}

std::string read_text(const fs::path& file) try {
  return read_bytes(file, largest_json);
} catch (const InputError& error) {
  throw ModelError(std::string(error.what()) + ", or train a model with `gestalt train`");
}

json read(const fs::path& file) {
  const std::string text = read_text(file);
  try {
    return parse_json(file.string(), text);
  } catch (const InputError& error) {
    throw ModelError(std::string(error.what()) + ", so it is not a model; " + retrain);
  }
}

Scaling read_scaling(const json& object, std::size_t columns) {
  Scaling scaling{numbers_field(object, "low"), numbers_field(object, "high")};
  if (scaling.low.size() != columns || scaling.high.size() != columns)
    throw ModelError("'scaling' must have one low and one high for each of the " + std::to_string(columns) + " names");
  for (std::size_t i = 0; i < columns; ++i)
    if (scaling.low[i] > scaling.high[i]) throw ModelError("'scaling' has a low above its high");
  return scaling;
}

}  // namespace

void require_both_classes(const Samples& samples) {
  const auto positive = std::count(samples.positive.begin(), samples.positive.end(), 1);
  const auto negative = std::ptrdiff_t(samples.rows()) - positive;
  if (positive == 0 || negative == 0)
    throw ModelError("training needs pairs of both classes, got " + std::to_string(positive) + " positive and " +
                     std::to_string(negative) + " negative; give more scenes with ground truth");
}

Scaling Scaling::of(const Samples& raw) {
  if (raw.rows() == 0) return {std::vector<double>(raw.columns), std::vector<double>(raw.columns)};
  const auto first = raw.row(0);
  Scaling scaling{{first.begin(), first.end()}, {first.begin(), first.end()}};
  for (std::size_t i = 1; i < raw.rows(); ++i)
    for (std::size_t c = 0; c < raw.columns; ++c) {
      scaling.low[c] = std::min(scaling.low[c], raw.row(i)[c]);
      scaling.high[c] = std::max(scaling.high[c], raw.row(i)[c]);
    }
  return scaling;
}

void Scaling::apply(std::span<const double> values, std::span<double> scaled) const {
  for (std::size_t c = 0; c < low.size(); ++c)
    scaled[c] = low[c] < high[c] ? std::clamp(2 * (values[c] - low[c]) / (high[c] - low[c]) - 1, -1.0, 1.0) : 0.0;
}

double Model::probability(std::span<const double> values) const {
  std::vector<double> scaled(values.size());
  scaling.apply(values, scaled);
  return predictor->probability(scaled);
}

std::vector<double> Model::probabilities(std::span<const double> values) const {
  std::vector<double> scaled(values.size());
  for (std::size_t at = 0; at < values.size(); at += names.size())
    scaling.apply(values.subspan(at, names.size()), std::span(scaled).subspan(at, names.size()));
  std::vector<double> p(values.size() / names.size());
  predictor->probabilities(scaled, p);
  return p;
}

Model train_model(const Classifier& classifier, std::string classifier_name, std::vector<std::string> names,
                  const Samples& samples, TrainingData training, std::string config_hash) {
  require_both_classes(samples);
  if (names.size() != samples.columns || samples.values.size() != samples.columns * samples.rows())
    throw ModelError("the samples do not have one value for each of: " + joined(names));
  if (!std::all_of(samples.values.begin(), samples.values.end(), is_model_number))
    throw ModelError("a relation's value is not in [-1e100, 1e100], as the numbers of a model must be");
  training.positive_pairs = std::size_t(std::count(samples.positive.begin(), samples.positive.end(), 1));
  training.negative_pairs = samples.rows() - training.positive_pairs;
  const Scaling scaling = Scaling::of(samples);
  Samples scaled = samples;
  for (std::size_t i = 0; i < samples.rows(); ++i)
    scaling.apply(samples.row(i), {scaled.values.data() + i * samples.columns, samples.columns});
  const ComponentName name = component_name("classifier", classifier_name);
  std::shared_ptr<const Predictor> predictor =
      call_component(name, [&] { return owned(name, classifier.train(scaled)); });
  if (!predictor)
    throw PluginError(std::string(name) + " returned no predictor from training; report this to its author");
  return {std::move(names),    scaling, std::move(classifier_name), std::move(config_hash), std::move(training),
          std::move(predictor)};
}

namespace {

json to_json(const Model& model) {
  return {{"names", model.names},
          {"scaling", {{"low", model.scaling.low}, {"high", model.scaling.high}}},
          {"classifier", model.classifier},
          {"config_hash", model.config_hash},
          {"training",
           {{"scenes", model.training.scenes},
            {"positive_pairs", model.training.positive_pairs},
            {"negative_pairs", model.training.negative_pairs}}},
          {"state", model.predictor->state()}};
}

[[noreturn]] void fail(const fs::path& file, const std::string& what) { throw ModelError(file.string() + ": " + what); }

/// The model's format and version are those of this program.
void check_format(const fs::path& file, const json& document) {
  if (!document.is_object() || document.value("format", json()) != format)
    fail(file, std::string("is not a model: 'format' is not \"") + format +
                   "\"; name a file that `gestalt train` has written");
  if (document.value("version", json()) != version)
    fail(file, "has version " + document.value("version", json()).dump(-1, ' ', false, json::error_handler_t::replace) +
                   " of the model format, this program reads version " + std::to_string(version) + "; " + retrain);
}

Model read_level(const fs::path& file, const json& document, Level level, const ExpectedModel& expected) {
  const std::string level_name = name_of(level);
  const auto levels = document.find("levels");
  if (levels == document.end() || !levels->is_object())
    fail(file, std::string("is damaged: 'levels' must hold the models by level; ") + retrain);
  if (!levels->contains(level_name))
    fail(file, "has no model of the " + level_name + " level; " + retrain +
                   " with this config, or use a config without that level");
  Model model;
  json state;
  try {
    const json& content = levels->at(level_name);
    model.names = texts_field(content, "names");
    model.scaling = read_scaling(field(content, "scaling"), model.names.size());
    model.classifier = text_field(content, "classifier");
    model.config_hash = text_field(content, "config_hash");
    const json& training = field(content, "training");
    model.training = {texts_field(training, "scenes"), count_field(training, "positive_pairs"),
                      count_field(training, "negative_pairs")};
    state = field(content, "state");
  } catch (const ModelError& error) {
    fail(file, "is damaged: " + level_name + " level: " + error.what() + "; " + retrain);
  }
  if (const std::string text = difference(model.names, expected.names); !text.empty())
    fail(file, level_name + " level: was trained on the relation values " + joined(model.names) + text + "; " +
                   retrain + ", or use the config that it was made for");
  if (model.classifier != expected.classifier_name)
    fail(file, level_name + " level: was trained with the classifier '" + model.classifier + "', the config has '" +
                   expected.classifier_name + "'; train one with `gestalt train SCENES --set " + level_name +
                   ".classifier=" + expected.classifier_name + " --output mine.json` and use it with --set " +
                   "model=mine.json, or set " + level_name + ".classifier to " + model.classifier);
  try {
    const ComponentName name = component_name("classifier", model.classifier);
    model.predictor =
        call_component(name, [&] { return owned(name, expected.classifier.restore(state, model.names.size())); });
  } catch (const std::exception& error) {
    fail(file, "is damaged: the state of its classifier '" + model.classifier + "' of the " + level_name +
                   " level: " + error.what() + "; " + retrain);
  }
  return model;
}

}  // namespace

void write_models(const fs::path& file, const Models& models) {
  json document{{"format", format}, {"version", version}, {"levels", {{"structural", to_json(models.structural)}}}};
  if (models.assembly) document["levels"]["assembly"] = to_json(*models.assembly);
  // A scene's name comes from a path, which may be no UTF-8.
  write_file(file, document.dump(-1, ' ', false, json::error_handler_t::replace) + "\n");
}

Models read_models(const fs::path& file, const ExpectedModel& structural,
                   const std::optional<ExpectedModel>& assembly) {
  const json document = read(file);
  check_format(file, document);
  Models models{read_level(file, document, Level::structural, structural), {}};
  if (assembly) models.assembly = read_level(file, document, Level::assembly, *assembly);
  return models;
}

}  // namespace gestalt
