// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "frame_options.h"

#include <algorithm>

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/image_file.h"
#include "gestalt/io/scene/scene_path.h"

namespace gestalt::app {

namespace fs = std::filesystem;

void add_frame_options(CLI::App& command, FrameOptions& options) {
  CLI::Option* const depth =
      command
          .add_option(
              "--depth", options.depth,
              "The depth image of the only frame, in place of INPUT: PNG or TIFF of 16 bits, PGM, EXR, npy, npz")
          ->type_name("FILE");
  command.add_option("--rgb", options.colour, "Its colour image, if there is one: PNG, JPEG, TIFF, PPM, EXR")
      ->needs(depth)
      ->type_name("FILE");
}

void require_input_or_frame(const std::vector<fs::path>& inputs, const FrameOptions& options) {
  if (inputs.empty() && options.depth.empty())
    throw CLI::ValidationError("inputs", "is required: a scene or a folder of scenes, or --depth and --rgb");
  std::error_code ignored;
  if (!options.depth.empty() && fs::equivalent(options.depth, options.colour, ignored))
    throw CLI::ValidationError("--rgb", "is the file of --depth; give the colour image, or leave --rgb out");
  if (!inputs.empty() && !options.depth.empty())
    throw CLI::ValidationError("--depth", "already gives the frame; remove the other inputs");
}

std::vector<fs::path> inputs_with_frame(std::vector<fs::path> inputs, FrameOptions& options) {
  if (!options.depth.empty()) return {options.depth};
  std::error_code ignored;
  const auto is_image = [&](const fs::path& path) {
    return has_image_extension(path) && fs::is_regular_file(path, ignored);
  };
  if (!std::all_of(inputs.begin(), inputs.end(), is_image)) return inputs;
  std::vector<fs::path> depth, others;
  for (const fs::path& input : inputs) (is_depth_image(input) ? depth : others).push_back(input);
  if (depth.empty() && inputs.size() == 1 && lower_extension(inputs.front()) == ".npy")
    return inputs;  // whose reader explains what to write
  if (depth.empty())
    throw InputError(inputs.front().string() + (inputs.size() > 1 ? ", " + inputs.back().string() : "") +
                     ": no depth image (one channel of 16 bits or floats), which is needed beside colour; give it as "
                     "--depth FILE --rgb " +
                     inputs.front().string());
  if (inputs.size() != 2 || others.empty()) return inputs;
  options.colour = others.front();
  return depth;
}

}  // namespace gestalt::app
