// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <regex>
#include <string>
#include <vector>

#include "command.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/output_file.h"
#include "gestalt/core/base/suggest.h"
#include "gestalt/core/plugin/registry.h"

namespace gestalt::app::new_plugin_command {

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kinds(kind_names.begin(), kind_names.end());

struct Options {
  std::string kind, name;
  fs::path folder;  ///< empty: named as the plugin
};

/// "my_relation" as a class: "MyRelation".
std::string class_name(const std::string& name) {
  std::string result;
  bool begins = true;
  for (const char c : name) {
    if (c != '_') result += begins ? char(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = c == '_';
  }
  return result;
}

/// The words of the templates, in files and in their names, and what stands for them.
std::string filled_in(std::string text, const Options& options) {
  const std::array<std::array<std::string, 2>, 3> words{
      {{"my_component", options.name}, {"MyComponent", class_name(options.name)}, {"my_kind", options.kind}}};
  for (const auto& [word, replacement] : words)
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += replacement.size())
      text.replace(at, word.size(), replacement);
  return text;
}

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad())
    throw Error("the template '" + file.string() + "' cannot be read; reinstall Gestalt");
  return text;
}

std::vector<OutputFile> project_files(const Options& options) {
  std::vector<OutputFile> files;
  for (const std::string& part : {std::string("common"), options.kind}) {
    const fs::path folder = data_directory() / "templates" / part;
    if (!fs::is_directory(folder))
      throw Error("the templates in '" + folder.string() + "' do not exist; reinstall Gestalt");
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      files.push_back({OutputPath(options.folder) / filled_in(entry.path().filename().string(), options),
                       filled_in(read(entry.path()), options)});
  }
  return files;
}

void check(const Options& options) {
  if (std::find(kinds.begin(), kinds.end(), options.kind) == kinds.end()) {
    std::string known;
    for (const std::string& kind : kinds) known += (known.empty() ? "" : ", ") + kind;
    throw ConfigError("unknown kind '" + options.kind + "'" + did_you_mean(options.kind, kinds) + " (known: " + known +
                      ")");
  }
  if (!std::regex_match(options.name, std::regex("[a-z]([a-z0-9]|_(?=[a-z0-9]))*")))
    throw ConfigError("'" + options.name + "' is not a valid plugin name: lower-case letters, digits and single " +
                      "underscores, such as my_relation");
  if (const Registry registry(plugin_search_path({})); registry.find(options.kind, options.name))
    throw ConfigError("a " + options.kind + " named '" + options.name + "' already exists in " +
                      registry.find(options.kind, options.name)->library.string() + "; choose another name");
  std::error_code ignored;
  if (fs::exists(options.folder, ignored) && !fs::is_empty(options.folder, ignored))
    throw ConfigError("'" + options.folder.string() + "' already exists; name a new or empty folder");
}

/// The option by which CMake finds this installation, where it does not look by itself.
std::string prefix_option() {
  const fs::path prefix = core_library().parent_path().parent_path();
  return prefix == "/usr" || prefix == "/usr/local" ? "" : " -DCMAKE_PREFIX_PATH=" + prefix.string();
}

int write_project(const Options& options) {
  check(options);
  const std::vector<OutputFile> files = project_files(options);
  std::error_code error;
  fs::create_directories(options.folder, error);
  if (error) throw OutputError("cannot create the folder '" + options.folder.string() + "': " + error.message());
  write_files(files);
  const std::string folder = options.folder.string();
  std::cout << "The " << options.kind << " '" << options.name << "' is in " << folder << ". Build and test it:\n"
            << "  cmake -S " << folder << " -B " << folder << "/build" << prefix_option() << '\n'
            << "  cmake --build " << folder << "/build\n"
            << "  ctest --test-dir " << folder << "/build --output-on-failure\n"
            << "Then change " << options.name << ".cpp; " << folder << "/README.md describes the rest.\n";
  return success;
}

void add_new_plugin(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("new-plugin", "Create a plugin project that builds and passes its tests, as a starting point");
  command->add_option("KIND", options->kind, "clusterer, fitter, relation, classifier or solver")->required();
  command->add_option("NAME", options->name, "Its name in configs, such as my_relation")->required();
  command->add_option("DIR", options->folder, "The folder of its project, new or empty (default: NAME)");
  command->footer("Example: gestalt new-plugin relation my_relation");
  command->callback([options, &run] {
    if (options->folder.empty()) options->folder = options->name;
    run = [options] { return write_project(*options); };
  });
}

const Subcommand subcommand(90, add_new_plugin);

}  // namespace

}  // namespace gestalt::app::new_plugin_command
