// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>

#include "gestalt/core/pipeline/segmenter.h"
#include "pipeline_options.h"

namespace gestalt::app {

/// What takes the place of the default config for scenes without colour: configs/depth_only.yaml with its model, loaded
/// when the first such scene comes.
class DepthOnly {
 public:
  /// Whether the user asked for nothing that it would replace: no config, model, relation or classifier.
  static bool may_replace(const PipelineOptions& options);

  /// reading: names how scenes are to be read.
  DepthOnly(const PipelineOptions& options, std::string reading);

  /// Thread-safe, as all methods.
  const Segmenter& segmenter() const { return loaded().segmenter; }

  /// As results tell it.
  const nlohmann::json& config() const { return loaded().config; }

  /// Names what its results follow from, but for the scene.
  const std::string& run() const { return loaded().run; }

  /// What to tell of a scene without colour; prints it on stderr for the first one.
  std::string note(const std::filesystem::path& scene) const;

 private:
  struct Loaded {
    Segmenter segmenter;
    nlohmann::json config;
    std::string run;
  };
  struct Shared {
    std::once_flag once, told;
    std::unique_ptr<Loaded> loaded;
  };
  const Loaded& loaded() const;

  PipelineOptions options_;
  std::string reading_;
  std::unique_ptr<Shared> shared_;
};

}  // namespace gestalt::app
