// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "depth_only.h"

#include <algorithm>
#include <iostream>

#include "gestalt/core/pipeline/run_identity.h"

namespace gestalt::app {

bool DepthOnly::may_replace(const PipelineOptions& options) {
  const auto is_of_the_model = [](const std::string& assignment) {
    const std::string path = assignment.substr(0, assignment.find('='));
    return path.starts_with("model") || path.find("relations") != path.npos || path.find("classifier") != path.npos;
  };
  return options.config.empty() && std::none_of(options.overrides.begin(), options.overrides.end(), is_of_the_model);
}

DepthOnly::DepthOnly(const PipelineOptions& options, std::string reading)
    : options_(options), reading_(std::move(reading)), shared_(std::make_unique<Shared>()) {
  options_.config = default_config().parent_path() / "depth_only.yaml";
}

const DepthOnly::Loaded& DepthOnly::loaded() const {
  std::call_once(shared_->once, [&] {
    Segmenter segmenter = load_segmenter(options_);
    nlohmann::json config = segmenter.config_json();
    std::string run = run_identity(segmenter.loaded()) + reading_;
    shared_->loaded = std::make_unique<Loaded>(Loaded{std::move(segmenter), std::move(config), std::move(run)});
  });
  return *shared_->loaded;
}

std::string DepthOnly::note(const std::filesystem::path& scene) const {
  const std::string note = "has no colour image; segmented by depth alone, with depth_only.yaml and its model";
  std::call_once(shared_->told, [&] { std::cerr << "gestalt: note: " + scene.string() + ": " + note + "\n"; });
  return note;
}

}  // namespace gestalt::app
