// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "gestalt/apps/output_check.h"
#include "gestalt/apps/pipeline_options.h"
#include "gestalt/apps/reading_options.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/output_file.h"
#include "gestalt/inspector/inspection/inspection.h"
#include "gestalt/io/result/result_digests.h"
#include "gestalt/io/result/result_file.h"
#include "gestalt/io/scene/input.h"

namespace gestalt::app::inspect_command {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Options {
  std::vector<fs::path> results;
  fs::path output = "inspector.html";
  fs::path scenes;         ///< empty: where the results say
  ReadingOptions reading;  ///< as the scene was segmented with
  PipelineOptions pipeline;
};

struct Result {
  fs::path file;
  json content;

  /// A member that is an object, or one that is a text; null when it is not there.
  const json* member(const char* key) const {
    const auto found = content.find(key);
    return found == content.end() ? nullptr : &*found;
  }
};

Result read(const fs::path& path) {
  std::error_code ignored;
  fs::path file = fs::is_directory(path, ignored) ? path / "result.json" : path;
  json content = read_result_content(file);
  if (const std::string warning = warning_of_foreign_files(file, content); !warning.empty())
    std::cerr << "gestalt: warning: " << warning << '\n';
  return {std::move(file), std::move(content)};
}

std::string text_of(const Result& result, const char* key) {
  const json* text = result.member(key);
  return text && text->is_string() ? text->get<std::string>() : "";
}

/// The scene among those of --scene that has the result's name; where there is only one, that.
fs::path choose(const std::vector<fs::path>& scenes, const Result& result, const fs::path& given) {
  if (scenes.size() == 1) return scenes[0];
  for (const fs::path& scene : scenes)
    if (scene_name(scene) == text_of(result, "scene")) return scene;
  throw InputError(given.string() + ": contains no scene named '" + text_of(result, "scene") + "', to which " +
                   result.file.string() + " refers");
}

fs::path scene_of(const Result& result, const Options& options) {
  if (!options.scenes.empty()) return choose(find_scenes({options.scenes}), result, options.scenes);
  const fs::path input = text_of(result, "input");
  std::error_code ignored;
  if (input.empty()) throw InputError(result.file.string() + ": does not record where its scene is; give --scene");
  if (!fs::exists(input, ignored))
    throw InputError(result.file.string() + ": its scene " + input.string() +
                     " does not exist; if it was moved, give its location with --scene");
  return input;
}

/// The config of the result, but for its plugin_directories: the file may be untrusted, and the user who opens it
/// must not run what lies where it says.
LoadedConfig load_config_of(const Result& result, const PipelineOptions& options) {
  if (!options.config.empty()) return load_config(options);
  const json* config = result.member("config");
  if (!config || !config->is_object() || !config->contains("values") || !config->at("values").is_object())
    throw InputError(result.file.string() + ": has no config; give it with --config");
  json values = config->at("values");
  const json directories = values.value("plugin_directories", json::array());
  values.erase("plugin_directories");
  ConfigTree tree = ConfigTree::from_text(
      result.file.string() + ": config", values.dump(1, ' ', false, json::error_handler_t::replace), options.overrides);
  const bool replaced = !tree.plugin_directories().empty();
  try {
    return LoadedConfig(std::move(tree));
  } catch (const ConfigError& error) {
    if (directories.empty() || replaced) throw;
    const std::string given = directories.dump(-1, ' ', false, json::error_handler_t::replace);
    throw ConfigError(std::string(error.what()) + "\n  not searched, because a result may be untrusted: " + given +
                      "; where you trust what lies there, add --set 'plugin_directories=" + given + "'");
  }
}

json inspect_result(const Result& result, const Options& options) {
  const Segmenter segmenter = load_segmenter(load_config_of(result, options.pipeline));
  const Input input = read_and_warn(scene_of(result, options), read_options(options.reading));
  json scene = inspect_scene(result.content, input, segmenter);
  for (const json& note : scene.at("notes"))
    std::cerr << "gestalt: warning: " << result.file.string() << ": " << note.get<std::string>() << '\n';
  return scene;
}

int inspect(const Options& options) {
  const ThreadLimit limit(options.pipeline.threads);
  std::vector<json> scenes;
  for (const fs::path& path : options.results) {
    const Result result = read(path);
    require_not_read("--output", options.output, {result.file});
    require_of_no_scene("--output", options.output, {scene_of(result, options)});
    scenes.push_back(inspect_result(result, options));
  }
  const std::string page = inspector_page(std::move(scenes));
  write_file(options.output, page);
  std::cout << options.output.string() << ": " << options.results.size()
            << (options.results.size() == 1 ? " scene, " : " scenes, ") << (page.size() + 999) / 1000 << " kB\n";
  return success;
}

void add_inspect(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "inspect", "Write a page that shows how results came about: layers, relations, the graph and its cut");
  command->add_option("RESULT", options->results, "result.json of scenes, or folders with one")->required();
  command->add_option("--output", options->output, "HTML file to write")->capture_default_str()->type_name("FILE");
  command->add_option("--scene", options->scenes, "Location of the scene, or of a folder of scenes, if it was moved")
      ->type_name("PATH");
  add_reading_options(*command, options->reading);
  add_pipeline_options(*command, options->pipeline);
  command->get_option("--config")->description("Config file (default: the config in the result)");
  command->footer("Example: gestalt inspect out/demo_scene --output demo.html");
  command->callback([options, &run] { run = [options] { return inspect(*options); }; });
}

const Subcommand subcommand(130, add_inspect);

}  // namespace

}  // namespace gestalt::app::inspect_command
