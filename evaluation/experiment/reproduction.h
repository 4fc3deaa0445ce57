// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gestalt/evaluation/experiment/ablation.h"
#include "gestalt/evaluation/experiment/experiment.h"
#include "gestalt/evaluation/experiment/peer.h"
#include "gestalt/evaluation/experiment/report.h"

namespace gestalt {

// The tables and figures of the paper's Section 8, from any labelled scenes and with any config.

/// The scenes of a data set: DATA/learn and DATA/test; without a test set cross-validation over DATA/learn, or over
/// DATA itself where it is a folder of scenes. Throws InputError.
Protocol find_protocol(const std::filesystem::path& data, int folds);

/// What the tables are made of: each value of a level alone, all without it, and each level with all. The assembly
/// level is left out if the config has levels: structural.
std::vector<Variant> reproduction_variants(const Config& config, const Registry& registry);

/// What the tables are made of.
struct Reproduction {
  const Protocol& protocol;
  std::vector<NamedResult> results;  ///< of reproduction_variants(), by name
  std::vector<PeerScores> peers;     ///< columns of Table 4
  bool papers_config = false;        ///< the config is configs/paper.yaml, so that reasons of its differences are known
};

/// Tables 1 to 4 with the paper's numbers and the differences, what differs in words, Figure 5, and how many
/// percentages are near the paper's.
Report reproduction_report(const Reproduction& reproduction);

/// {"variants": {name: result}, "peers": {name: {"scores": [...], "further": [...]}}, "summary": {"Table 2":
/// {"percentages": n, "within_1": n, "within_3": n}, ...}, "paper": {"table_1": [...], ...}}; percentages of the paper
/// as it prints them.
nlohmann::ordered_json reproduction_json(const Reproduction& reproduction);

}  // namespace gestalt
