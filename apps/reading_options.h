// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gestalt/io/scene/input.h"

namespace gestalt::app {

/// What a user tells of his scenes: --camera or --fx, --fy, --cx and --cy, --unit or --depth-scale, --depth-kind,
/// --labels. Every command that reads scenes has them.
struct ReadingOptions {
  std::filesystem::path camera;          ///< empty: that of each scene
  std::optional<double> fx, fy, cx, cy;  ///< in place of a camera file; all or none, fy may be missing
  std::optional<double> depth_scale;
  DepthKind depth_kind = DepthKind::plain;
  LabelScheme labels = LabelScheme::guess;
  std::filesystem::path colour;  ///< of the only scene, a depth image; empty: what is found with it
};

void add_reading_options(CLI::App& command, ReadingOptions& options);

/// Reads the camera file. Throws InputError.
ReadOptions read_options(const ReadingOptions& options);

/// All but the camera: equal for equal options.
std::string text_of(const ReadingOptions& options);

/// Prints the warnings of a scene, and those of its notes that no scene had before, on stderr.
void tell(const std::filesystem::path& scene, const std::vector<std::string>& warnings,
          const std::vector<std::string>& notes);

/// read_scene(), its warnings and notes told.
Input read_and_warn(const std::filesystem::path& scene, const ReadOptions& options);

}  // namespace gestalt::app
