// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gestalt/core/base/output_file.h"
#include "gestalt/evaluation/experiment/ablation.h"
#include "gestalt/evaluation/experiment/experiment.h"

namespace gestalt::app {

/// run_experiments() with a progress bar; warnings and the variants that failed are reported on stderr. Throws the
/// first failure when no variant has a result.
std::vector<ExperimentOutcome> run_with_progress(const std::vector<Variant>& variants, const Registry& registry,
                                                 const Protocol& protocol, const OutputPath& store);

/// Variants with their results. Keeps references.
std::vector<NamedResult> named(const std::vector<Variant>& variants, const std::vector<ExperimentOutcome>& outcomes);

/// success, or run_failed when some variants failed.
int exit_code(const std::vector<ExperimentOutcome>& outcomes);

/// The report as <name>.md and <name>.html, and its plots, in the folder.
std::vector<OutputFile> report_files(const Report& report, const OutputPath& folder, const std::string& name);

/// Throws ConfigError when two scenes, one to learn from and one to test, are the same.
void require_apart(const Protocol& protocol);

}  // namespace gestalt::app
