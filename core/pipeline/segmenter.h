// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gestalt/core/config/loaded_config.h"
#include "gestalt/core/pipeline/pipeline.h"

namespace gestalt {

/// What was found in a frame.
struct SegmentedFrame {
  Percept percept;
  Segmentation segmentation;
  LevelTimes times;
};

/// The segmenter: a config with its plugins, its pipeline and its trained models. Immutable; may be used from many
/// threads at once, and gives the same result for any number of threads.
class GESTALT_EXPORT Segmenter {
 public:
  /// A config and overrides as of ConfigTree. Throws ConfigError, PluginError, ModelError.
  explicit Segmenter(const std::filesystem::path& config = default_config(),
                     const std::vector<std::string>& overrides = {});
  explicit Segmenter(LoadedConfig loaded);

  /// Throws as Pipeline::perceive() and Pipeline::decide() do.
  SegmentedFrame segment(const Frame& frame) const;

  const LoadedConfig& loaded() const { return loaded_; }
  const Config& config() const { return pipeline_.config(); }
  const Registry& registry() const { return loaded_.registry; }
  const Pipeline& pipeline() const { return pipeline_; }
  const Models& models() const { return models_; }

  /// ConfigTree::to_json(): what results keep of the config.
  nlohmann::json config_json() const;

  /// What its user should know before it is used, one sentence: the model was trained with other parameters of the
  /// levels below the classifier. "" where there is nothing to say.
  std::string warning() const;

 private:
  LoadedConfig loaded_;
  Pipeline pipeline_;
  Models models_;
};

}  // namespace gestalt
