// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/config/config.h"

#include <nlohmann/json.hpp>

#include "config_draft.h"
#include "config_files.h"
#include "config_overrides.h"
#include "config_print.h"
#include "config_resolution.h"

namespace gestalt {

struct ConfigTree::Tree {
  config::Draft draft;
};

ConfigTree::ConfigTree(const std::filesystem::path& file, const std::vector<std::string>& overrides)
    : tree_(std::make_unique<Tree>()) {
  config::Draft& draft = tree_->draft;
  const std::vector<config::Node> roots = config::read_files(file, draft.problems);
  draft.start = {roots.back().place.source, 1, 1};
  for (const config::Node& root : roots) config::merge(draft, root);
  for (const std::string& text : overrides) config::merge(draft, config::read_override(text, draft.problems));
}

ConfigTree ConfigTree::from_text(const std::string& name, const std::string& text,
                                 const std::vector<std::string>& overrides) {
  auto tree = std::make_unique<Tree>();
  config::Draft& draft = tree->draft;
  const config::Node root = config::read_root(name, text, draft.problems);
  draft.start = {root.place.source, 1, 1};
  config::merge(draft, root);
  for (const std::string& override : overrides) config::merge(draft, config::read_override(override, draft.problems));
  return ConfigTree(std::move(tree));
}

ConfigTree::ConfigTree(std::unique_ptr<Tree> tree) : tree_(std::move(tree)) {}

ConfigTree::~ConfigTree() = default;
ConfigTree::ConfigTree(ConfigTree&&) noexcept = default;
ConfigTree& ConfigTree::operator=(ConfigTree&&) noexcept = default;

std::vector<std::filesystem::path> ConfigTree::plugin_directories() const {
  std::vector<std::filesystem::path> directories;
  for (const config::DirectoryDraft& d : tree_->draft.plugin_directories) directories.push_back(d.directory);
  return directories;
}

Config ConfigTree::resolve(const Registry& registry) const { return config::resolve(tree_->draft, registry).config; }

std::string ConfigTree::print(const Registry& registry) const {
  return config::to_yaml(config::resolve(tree_->draft, registry));
}

nlohmann::json ConfigTree::to_json(const Registry& registry) const {
  return config::to_json(config::resolve(tree_->draft, registry));
}

std::filesystem::path default_config() {
  const std::filesystem::path file = data_directory() / "configs" / "default.yaml";
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored))
    throw ConfigError("the default config '" + file.string() +
                      "' does not exist; name another one, or reinstall Gestalt");
  return file;
}

}  // namespace gestalt
