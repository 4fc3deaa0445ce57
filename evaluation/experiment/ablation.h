// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gestalt/evaluation/experiment/experiment.h"
#include "gestalt/evaluation/experiment/report.h"

namespace gestalt {

/// A named list of overrides of a config, each "path=value" as for ConfigTree.
struct OverrideSet {
  std::string name;
  std::vector<std::string> overrides;
};

/// Reads a YAML file that maps each name to an override or a list of them. Throws ConfigError with file, line and
/// column.
std::vector<OverrideSet> read_override_sets(const std::filesystem::path& file);

/// Every combination of the values of axes, each "path=v1,v2,..."; the last axis changes fastest. A set is named after
/// its overrides. Throws ConfigError for what is not an axis.
std::vector<OverrideSet> grid(const std::vector<std::string>& axes);

enum class EachMode { only, without };

/// The targets that each() knows: structural.relations, structural.values, assembly.relations, assembly.values.
const std::vector<std::string>& each_targets();

/// A variant for each relation (or each value of them) of a level of the base's config: with only that one, or without
/// it. Throws ConfigError for an unknown target, with the closest one, for a level that the config lacks, and
/// where nothing would be left.
std::vector<Variant> each(const Variant& base, const Registry& registry, const std::string& target, EachMode mode);

/// Names of the values that the relations of a level of a config give, in order. Throws ConfigError when the config
/// lacks the level.
std::vector<std::string> level_values(const Config& config, const Registry& registry, Level level);

/// A variant with its result, or null when it has none.
struct NamedResult {
  std::string name;
  const ExperimentResult* result;
};

/// Scores of all variants and their differences to the first, as tables and plots.
Report ablation_report(const std::string& title, const std::string& protocol, const std::vector<NamedResult>& results);

/// The same numbers, as fractions, a row for each variant and category.
TextTable ablation_rows(const std::vector<NamedResult>& results);

/// How a protocol's scenes are used, in words.
std::string description(const Protocol& protocol);

}  // namespace gestalt
