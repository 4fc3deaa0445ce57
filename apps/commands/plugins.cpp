// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "command.h"
#include "gestalt/core/base/suggest.h"
#include "gestalt/core/config/config.h"
#include "gestalt/core/plugin/registry.h"

namespace gestalt::app::plugins_command {

namespace {

using nlohmann::json;

struct Options {
  std::filesystem::path config;    ///< whose plugin_directories are searched first; empty: none
  std::vector<std::string> words;  ///< of describe: [KIND] NAME
  bool json = false;
};

Registry open_registry(const Options& options) {
  std::vector<std::filesystem::path> directories;
  if (!options.config.empty()) directories = ConfigTree(options.config, {}).plugin_directories();
  return Registry(plugin_search_path(directories));
}

/// The order of the method: from pixels to objects, each kind by name.
std::vector<ComponentInfo> in_order(const Registry& registry) {
  std::vector<ComponentInfo> components;
  for (const char* kind : kind_names)
    for (const std::string& name : registry.names(kind)) components.push_back(*registry.find(kind, name));
  return components;
}

void print_search(const Registry& registry) {
  std::cout << "\nsearched:\n";
  for (const std::filesystem::path& directory : registry.searched())
    std::cout << "  " << directory.string() << (std::filesystem::is_directory(directory) ? "" : " (not there)") << '\n';
  if (!registry.rejected().empty()) std::cout << "rejected:\n";
  for (const RejectedLibrary& rejected : registry.rejected())
    std::cout << "  " << rejected.library.string() << ": " << rejected.reason << '\n';
}

json search_json(const Registry& registry) {
  json searched = json::array();
  for (const std::filesystem::path& directory : registry.searched()) searched.push_back(directory.string());
  json rejected = json::array();
  for (const RejectedLibrary& r : registry.rejected())
    rejected.push_back({{"library", r.library.string()}, {"reason", r.reason}});
  return {{"searched", searched}, {"rejected", rejected}};
}

json info_json(const ComponentInfo& info) {
  return {{"kind", info.kind},
          {"name", info.name},
          {"version", info.version},
          {"description", info.description},
          {"library", info.library.string()}};
}

void print_json(const json& value) { std::cout << value.dump(2, ' ', false, json::error_handler_t::replace) << '\n'; }

int list(const Options& options) {
  const Registry registry = open_registry(options);
  const std::vector<ComponentInfo> components = in_order(registry);
  if (options.json) {
    json all = search_json(registry);
    all["components"] = json::array();
    for (const ComponentInfo& info : components) all["components"].push_back(info_json(info));
    print_json(all);
    return success;
  }
  std::size_t width = 4;
  for (const ComponentInfo& info : components) width = std::max(width, info.name.size());
  for (const ComponentInfo& info : components)
    std::cout << std::left << std::setw(12) << info.kind << std::setw(int(width) + 2) << info.name << std::setw(8)
              << info.version << info.description << '\n';
  print_search(registry);
  return success;
}

/// The component that `describe` is asked for. A name without a kind has to be of one kind only.
ComponentInfo find(const Registry& registry, const std::vector<std::string>& words) {
  const std::string& name = words.back();
  if (words.size() == 2) {
    if (std::find(kind_names.begin(), kind_names.end(), words[0]) == kind_names.end())
      throw ConfigError("'" + words[0] + "' is not a kind of component" +
                        did_you_mean(words[0], {kind_names.begin(), kind_names.end()}));
    registry.parameters(words[0], name);  // throws when there is none, naming what was searched
    return *registry.find(words[0], name);
  }
  std::vector<ComponentInfo> found;
  std::vector<std::string> names;
  for (const ComponentInfo& info : in_order(registry)) {
    names.push_back(info.name);
    if (info.name == name) found.push_back(info);
  }
  if (found.size() == 1) return found[0];
  if (found.size() > 1)
    throw ConfigError("'" + name + "' is a " + found[0].kind + " and a " + found[1].kind +
                      "; say which, as in: gestalt plugins describe " + found[0].kind + " " + name);
  std::string message = "no plugin offers a component '" + name + "'" + did_you_mean(name, names) + "\n  searched:";
  for (const std::filesystem::path& directory : registry.searched()) message += "\n    " + directory.string();
  if (!registry.rejected().empty()) message += "\n  rejected:";
  for (const RejectedLibrary& r : registry.rejected()) message += "\n    " + r.library.string() + ": " + r.reason;
  throw PluginError(message);
}

json number_or_null(double bound) { return std::isfinite(bound) ? json(bound) : json(); }

json parameter_json(const Parameter& p) {
  json out{{"name", p.name}, {"type", to_string(p.type)}, {"unit", p.unit}, {"text", p.text}};
  std::visit([&](const auto& value) { out["default"] = value; }, p.default_value);
  if (p.type == Parameter::Type::choice) out["choices"] = p.choices;
  if (p.type == Parameter::Type::integer || p.type == Parameter::Type::real)
    out["range"] = {number_or_null(p.minimum), number_or_null(p.maximum)};
  return out;
}

json describe_json(const ComponentInfo& info, const std::vector<Parameter>& parameters, const Relation* relation) {
  json out = info_json(info);
  out["parameters"] = json::array();
  for (const Parameter& p : parameters) out["parameters"].push_back(parameter_json(p));
  if (relation == nullptr) return out;
  out["needs_colour"] = relation->needs_colour();
  out["needs_border"] = relation->needs_border();
  out["values"] = json::array();
  for (const RelationValue& v : relation->values())
    out["values"].push_back(
        {{"name", v.name}, {"range", {number_or_null(v.low), number_or_null(v.high)}}, {"text", v.text}});
  return out;
}

void print_parameter(const Parameter& p) {
  std::cout << "  " << p.name << ": " << to_string(p.type);
  if (const std::string range = range_text(p); !range.empty()) std::cout << " " << range;
  if (!p.unit.empty()) std::cout << " " << p.unit;
  std::cout << ", default " << to_string(p.default_value) << "\n      " << p.text << '\n';
}

int describe(const Options& options) {
  const Registry registry = open_registry(options);
  const ComponentInfo info = find(registry, options.words);
  const std::vector<Parameter>& parameters = registry.parameters(info.kind, info.name);
  std::shared_ptr<const Relation> relation;
  if (info.kind == kind_name<Relation>) relation = registry.create<Relation>(info.name, {});

  if (options.json) {
    json all = describe_json(info, parameters, relation.get());
    all.update(search_json(registry));
    print_json(all);
    return success;
  }
  std::cout << info.kind << ' ' << info.name << ' ' << info.version << "\n  " << info.description << "\n  "
            << info.library.string() << '\n';
  if (relation) {
    std::cout << "\nvalues" << (relation->needs_colour() ? ", need colour" : "")
              << (relation->needs_border() ? ", need a common border" : "") << ":\n";
    for (const RelationValue& v : relation->values())
      std::cout << "  " << v.name << ": [" << to_string(v.low) << ", " << to_string(v.high) << "]\n      " << v.text
                << '\n';
  }
  std::cout << "\nparameters:" << (parameters.empty() ? " none\n" : "\n");
  for (const Parameter& p : parameters) print_parameter(p);
  print_search(registry);
  return success;
}

void add_options(CLI::App& command, Options& options) {
  command.add_option("--config", options.config, "Also search the plugin_directories of this config")
      ->type_name("FILE");
  command.add_flag("--json", options.json, "Print as JSON");
}

void add_plugins(CLI::App& app, Run& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("plugins", "List or describe the components that plugins offer");
  command->require_subcommand(1);
  command->footer("Example: gestalt plugins describe gabor");

  CLI::App* list_command =
      command->add_subcommand("list", "List all components, where they were searched and what was rejected");
  add_options(*list_command, *options);
  list_command->footer("Example: gestalt plugins list");
  list_command->callback([options, &run] { run = [options] { return list(*options); }; });

  CLI::App* describe_command = command->add_subcommand("describe", "Describe a component's parameters and values");
  describe_command->add_option("component", options->words, "[KIND] NAME, as in: relation gabor")
      ->type_name("NAME")
      ->required()
      ->expected(1, 2);
  add_options(*describe_command, *options);
  describe_command->footer("Example: gestalt plugins describe gabor");
  describe_command->callback([options, &run] { run = [options] { return describe(*options); }; });
}

const Subcommand subcommand(100, add_plugins);

}  // namespace

}  // namespace gestalt::app::plugins_command
