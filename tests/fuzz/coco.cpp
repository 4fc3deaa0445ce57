// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Instances of COCO as the ground truth of a scene of 4x2 pixels.

#include "gestalt/io/scene/ground_truth.h"

#include "scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt;
  using namespace gestalt::fuzz;
  static const Scratch scratch;
  const std::filesystem::path folder = scratch.write("coco.json", text_of(data, size)).parent_path();
  Input input;
  read_ground_truth_beside(input, folder, cv::Mat(2, 4, CV_8U, cv::Scalar(255)), LabelScheme::guess);
  return 0;
}
