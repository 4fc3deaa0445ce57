// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/pipeline/segmenter.h"

#include <nlohmann/json.hpp>

namespace gestalt {

Segmenter::Segmenter(const std::filesystem::path& config, const std::vector<std::string>& overrides)
    : Segmenter(LoadedConfig(ConfigTree(config, overrides))) {}

Segmenter::Segmenter(LoadedConfig loaded)
    : loaded_(std::move(loaded)), pipeline_(loaded_.config, loaded_.registry), models_(pipeline_.load_models()) {}

SegmentedFrame Segmenter::segment(const Frame& frame) const {
  SegmentedFrame found;
  found.percept = pipeline_.perceive(frame);
  found.times = found.percept.times;
  found.segmentation = pipeline_.decide(found.percept, models_, &found.times);
  return found;
}

nlohmann::json Segmenter::config_json() const { return loaded_.tree.to_json(loaded_.registry); }

std::string Segmenter::warning() const {
  if (!pipeline_.trained_otherwise(models_)) return "";
  return config().model.string() +
         " was trained with different parameters of the levels below the classifier; retrain it with this config";
}

}  // namespace gestalt
