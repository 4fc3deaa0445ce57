// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gestalt/evaluation/experiment/experiment.h"

namespace gestalt {

/// Another program, by the label images that it made of the scenes: `FOLDER/<scene>/labels.png` or
/// `FOLDER/<scene>.png`, 0 = no segment.
struct Peer {
  std::string name;
  std::filesystem::path folder;
};

struct PeerScores {
  std::string name;
  std::vector<CategoryScore> scores;   ///< of the scenes that a protocol evaluates, as ExperimentResult::scores
  std::vector<CategoryScore> further;  ///< a row for each further set that the peer has label images of
};

/// Scores of a peer on the scenes of a protocol. A further set of which it has no label image is left out; any other
/// scene without one is an InputError.
PeerScores score_peer(const Peer& peer, const Protocol& protocol);

}  // namespace gestalt
