// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "depth_only.h"

#include <iostream>

#include "gestalt/core/pipeline/run_identity.h"
#include "reading_options.h"

namespace gestalt::app {

DepthOnly::DepthOnly(const PipelineOptions& options, std::string reading)
    : options_(options), reading_(std::move(reading)), shared_(std::make_unique<Shared>()) {
  options_.config = depth_only_config();
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

bool depth_only_may_replace(const PipelineOptions& options) {
  return gestalt::depth_only_may_replace(options.config, options.overrides);
}

PipelineOptions options_for_all(PipelineOptions options, const std::vector<std::filesystem::path>& scenes,
                                const ReadOptions& read, const std::string& remark) {
  if (!depth_only_may_replace(options) || !none_has_colour(scenes, read)) return options;
  std::cerr << "gestalt: note: no scene has a colour image; depth alone is used, with depth_only.yaml" + remark + "\n";
  options.config = depth_only_config();
  return options;
}

Input read_one_of_many(const std::filesystem::path& scene, const ReadOptions& read, const PipelineOptions& options) {
  Input input = read_and_warn(scene, read);
  if (depth_only_may_replace(options)) require_colour_as_of_others(input);
  return input;
}

}  // namespace gestalt::app
