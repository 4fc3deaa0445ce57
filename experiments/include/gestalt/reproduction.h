// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gestalt/ablation.h"
#include "gestalt/experiment.h"
#include "gestalt/report.h"

namespace gestalt {

// The tables and figures of the paper's Section 8, from any labelled scenes and with any config.

/// The scenes of a data set: DATA/learn and DATA/test; without a test set cross-validation over DATA/learn, or over
/// DATA itself where it is a folder of scenes. Throws InputError.
Protocol find_protocol(const std::filesystem::path& data, int folds);

/// What the tables are made of: each value of a level alone, all without it, and each level with all. The assembly
/// level is left out where the config has no such section.
std::vector<Variant> reproduction_variants(const Config& config, const Registry& registry);

/// Tables 1 to 4 beside the paper's numbers, and Figure 5. results: of the variants, by name.
Report reproduction_report(const Protocol& protocol, const std::vector<NamedResult>& results);

/// {"variants": {name: result}, "paper": {"table_1": [...], ...}}; percentages of the paper as it prints them.
nlohmann::ordered_json reproduction_json(const std::vector<NamedResult>& results);

}  // namespace gestalt
