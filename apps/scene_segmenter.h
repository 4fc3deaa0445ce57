// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "depth_only.h"
#include "gestalt/core/pipeline/segmenter.h"
#include "gestalt/io/scene/input.h"
#include "pipeline_options.h"
#include "reading_options.h"
#include "stream/scene_tracker.h"

namespace gestalt::app {

struct SegmenterOptions {
  std::filesystem::path output = "out";
  ReadingOptions reading;
  bool debug_images = false;
  std::vector<std::string> also;  ///< of what other programs read: pcd, ply, coco
  PipelineOptions pipeline;
};

/// Also the shorthands --sensor, --max-depth and --min-object, of which --set overrides the value.
void add_segmenter_options(CLI::App& command, SegmenterOptions& options);

/// What was found in a scene.
struct SegmentedScene {
  std::filesystem::path folder;  ///< of the results
  std::size_t objects = 0;       ///< segments that are not background
  std::size_t patches = 0;
  double milliseconds = 0;  ///< of all levels
  nlohmann::json tracks{};  ///< of a tracker; null without
};

/// Segments scenes and writes their results, each into a folder of its own.
class SceneSegmenter {
 public:
  /// Loads config, plugins and model.
  explicit SceneSegmenter(const SegmenterOptions& options);

  /// May be called from many threads, as all methods; with a tracker, from one at a time, in the order of the frames.
  SegmentedScene segment(const std::filesystem::path& scene, SceneTracker* tracker = nullptr) const;

  /// The folder of a scene's results.
  std::filesystem::path folder_of(const std::filesystem::path& scene) const;

  /// Whether an earlier run has left there what segment() would give (is_segmented()).
  bool has_segmented(const std::filesystem::path& scene) const;

 private:
  std::filesystem::path output_;
  bool debug_images_;
  std::set<std::string> also_;
  ReadOptions read_;
  Segmenter segmenter_;
  nlohmann::json config_;                ///< as results tell it, but for identity
  std::optional<DepthOnly> depth_only_;  ///< for scenes without colour; nothing: the user asked for a config of his own
  std::string run_;                      ///< what the results of all scenes follow from
};

}  // namespace gestalt::app
