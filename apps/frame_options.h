// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <vector>

namespace gestalt::app {

/// One frame by its images, without a folder: --depth and --rgb.
struct FrameOptions {
  std::filesystem::path depth, colour;
};

void add_frame_options(CLI::App& command, FrameOptions& options);

/// Throws CLI::ValidationError where neither inputs nor a frame are given, and where both are.
void require_input_or_frame(const std::vector<std::filesystem::path>& inputs, const FrameOptions& options);

/// The inputs of a command, or the frame of the options; or, where the inputs are two images of which one alone can be
/// depth, that one, the other becoming its colour. Throws InputError for images of which none can be depth.
std::vector<std::filesystem::path> inputs_with_frame(std::vector<std::filesystem::path> inputs, FrameOptions& options);

}  // namespace gestalt::app
