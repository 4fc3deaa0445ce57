// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gestalt/core/pipeline/segmenter.h"
#include "gestalt/io/scene/depth_only.h"
#include "pipeline_options.h"

namespace gestalt::app {

/// What takes the place of the default config for scenes without colour: configs/depth_only.yaml with its model, loaded
/// when the first such scene comes.
class DepthOnly {
 public:
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

/// Whether it may take the place of what the options ask for (depth_only_may_replace()).
bool depth_only_may_replace(const PipelineOptions& options);

/// Options for scenes that are trained on or scored together: as they are; or with depth_only.yaml where it may replace
/// the default and no scene has colour, which is reported on stderr, with a remark behind it.
PipelineOptions options_for_all(PipelineOptions options, const std::vector<std::filesystem::path>& scenes,
                                const ReadOptions& read, const std::string& remark = "");

/// read_and_warn() of one of them. Throws InputError where it alone has no colour, and no config was asked for.
Input read_one_of_many(const std::filesystem::path& scene, const ReadOptions& read, const PipelineOptions& options);

}  // namespace gestalt::app
