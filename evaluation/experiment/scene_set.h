// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "gestalt/evaluation/experiment/experiment.h"

namespace gestalt {

/// A scene of a protocol.
struct SceneUse {
  std::filesystem::path path;
  std::string name;
  std::string category;
  bool learnt = true;  ///< a learn scene
  bool scored = true;  ///< a test scene, or any of a cross-validation
  int model = 0;       ///< the model that judges it: its fold, which it was not trained on, or that of all learn scenes
  int further = -1;    ///< index of its further set; -1: of the protocol's own scenes
};

/// The scenes of a protocol, those to learn from first, those of further sets last. Throws InputError, ConfigError.
struct SceneSet {
  explicit SceneSet(const Protocol& protocol);

  std::vector<SceneUse> scenes;
  std::vector<int> fold;  ///< of each scene; empty without cross-validation
  int folds = 0;          ///< 0 without cross-validation
  ReadOptions read;       ///< of all scenes
};

/// The scenes' contents and uses as text: equal for equal experiments, wherever the files are. Throws InputError.
std::string canonical(const SceneSet& set);

}  // namespace gestalt
