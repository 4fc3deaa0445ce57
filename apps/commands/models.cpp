// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "command.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/suggest.h"
#include "gestalt/core/plugin/registry.h"

namespace gestalt::app::models_command {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct DataSet {
  std::string text, sensor, licence;
  int scenes = 0;
};

struct InstalledModel {
  std::string name, config, text, licence;
  std::vector<DataSet> data;
  std::vector<double> osd;      ///< precision and recall of objects in %; empty: not measured
  std::vector<double> clutter;  ///< overlap F and objects with F > 0.75 in %; empty: not measured
};

fs::path file_of(const InstalledModel& model) { return data_directory() / "models" / (model.name + ".json"); }

/// models.yaml of this installation, in its order.
std::vector<InstalledModel> installed_models() {
  const fs::path file = data_directory() / "models" / "models.yaml";
  try {
    const YAML::Node catalogue = YAML::LoadFile(file.string());
    std::vector<InstalledModel> models;
    for (const auto& entry : catalogue["models"]) {
      const YAML::Node& facts = entry.second;
      InstalledModel model{entry.first.as<std::string>(),
                           facts["config"].as<std::string>(),
                           facts["text"].as<std::string>(),
                           facts["licence"].as<std::string>(),
                           {},
                           {},
                           {}};
      for (const auto& name : facts["data"]) {
        const YAML::Node set = catalogue["data"][name.as<std::string>()];
        model.data.push_back({set["text"].as<std::string>(), set["sensor"].as<std::string>(),
                              set["licence"].as<std::string>(), set["scenes"].as<int>()});
      }
      model.osd = facts["score"]["osd"].as<std::vector<double>>(std::vector<double>{});
      model.clutter = facts["score"]["clutter"].as<std::vector<double>>(std::vector<double>{});
      models.push_back(std::move(model));
    }
    return models;
  } catch (const YAML::Exception& error) {
    throw ConfigError(file.string() + ": cannot be read as the list of models: " + error.what() +
                      "; install Gestalt again");
  }
}

const InstalledModel& find(const std::vector<InstalledModel>& models, const std::string& name) {
  const std::string stem = name.ends_with(".json") ? name.substr(0, name.size() - 5) : name;
  std::vector<std::string> names;
  for (const InstalledModel& model : models) {
    if (model.name == stem) return model;
    names.push_back(model.name);
  }
  std::string all;
  for (const std::string& one : names) all += (all.empty() ? "" : ", ") + one;
  throw ConfigError("there is no installed model '" + name + "'; the installed ones are " + all +
                    did_you_mean(stem, names) + "\n  A model file of your own is described by `gestalt info FILE`.");
}

std::string both(const std::vector<double>& score) {
  if (score.size() != 2) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << score[0] << " / " << score[1];
  return text.str();
}

std::string use_of(const InstalledModel& model) {
  return "gestalt segment INPUT" + (model.config == "default.yaml" ? "" : " --config " + model.config) +
         (model.config == model.name + ".yaml" ? "" : " --set model=" + model.name + ".json");
}

ordered_json to_json(const InstalledModel& model) {
  ordered_json data = ordered_json::array();
  for (const DataSet& set : model.data)
    data.push_back({{"text", set.text}, {"scenes", set.scenes}, {"sensor", set.sensor}, {"licence", set.licence}});
  ordered_json score = ordered_json::object();
  if (model.osd.size() == 2) score["osd"] = {{"precision", model.osd[0]}, {"recall", model.osd[1]}};
  if (model.clutter.size() == 2)
    score["clutter"] = {{"overlap_f", model.clutter[0]}, {"objects_above_0.75", model.clutter[1]}};
  return {
      {"name", model.name},       {"file", file_of(model).string()}, {"config", model.config}, {"text", model.text},
      {"licence", model.licence}, {"score_percent", score},          {"training_data", data},  {"use", use_of(model)}};
}

int list(bool json) {
  const std::vector<InstalledModel> models = installed_models();
  if (json) {
    ordered_json all = ordered_json::array();
    for (const InstalledModel& model : models) all.push_back(to_json(model));
    std::cout << all.dump(2) << '\n';
    return success;
  }
  const auto line = [](const std::string& name, const std::string& config, const std::string& osd,
                       const std::string& clutter, const std::string& licence, const std::string& text) {
    std::cout << std::left << std::setw(12) << name << std::setw(17) << config << std::setw(14) << osd << std::setw(14)
              << clutter << std::setw(10) << licence << text << '\n';
  };
  line("model", "config", "OSD", "clutter", "licence", "");
  for (const InstalledModel& model : models)
    line(model.name, model.config, both(model.osd), both(model.clutter), model.licence, model.text);
  std::cout
      << "\nOSD: precision / recall of objects, cross-validated on the learn set, in %.\n"
         "clutter: overlap F / objects with F > 0.75, 14 frames of five other sensors, left out of training, in %.\n"
         "Training data and use of one: gestalt models info NAME\n";
  return success;
}

int info(const std::string& name, bool json) {
  const std::vector<InstalledModel> models = installed_models();
  const InstalledModel& model = find(models, name);
  if (json) {
    std::cout << to_json(model).dump(2) << '\n';
    return success;
  }
  std::cout << model.name << ": " << model.text << "\n\nfile:    " << file_of(model).string()
            << "\nconfig:  " << model.config << "\nlicence: " << model.licence << "\nOSD:     " << both(model.osd)
            << (model.osd.empty() ? "" : " % precision / recall of objects, cross-validated on the learn set")
            << "\nclutter: " << both(model.clutter)
            << (model.clutter.empty()
                    ? ""
                    : " % overlap F / objects with F > 0.75, 14 frames of five other sensors, left out "
                      "of training")
            << "\nuse:     " << use_of(model) << "\n\ntrained on:\n";
  for (const DataSet& set : model.data)
    std::cout << "  " << set.text << "\n      " << set.scenes << (set.scenes == 1 ? " scene, " : " scenes, ")
              << set.sensor << "; licence: " << set.licence << '\n';
  std::cout << "\nValues and scaling: gestalt info " << file_of(model).string() << '\n';
  return success;
}

void add_models(CLI::App& app, Run& run) {
  struct Options {
    std::string name;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("models", "List or describe the installed models: score, training data, licence");
  command->require_subcommand(1);
  command->footer("Example: gestalt models info synthetic");

  CLI::App* list_command = command->add_subcommand("list", "List the installed models with their scores and licences");
  list_command->add_flag("--json", options->json, "Print as JSON");
  list_command->footer("Example: gestalt models list");
  list_command->callback([options, &run] { run = [options] { return list(options->json); }; });

  CLI::App* info_command =
      command->add_subcommand("info", "Describe an installed model: score, training data, licence, use");
  info_command->add_option("NAME", options->name, "Name of an installed model")->required();
  info_command->add_flag("--json", options->json, "Print as JSON");
  info_command->footer("Example: gestalt models info default");
  info_command->callback([options, &run] { run = [options] { return info(options->name, options->json); }; });
}

const Subcommand subcommand(105, add_models);

}  // namespace

}  // namespace gestalt::app::models_command
