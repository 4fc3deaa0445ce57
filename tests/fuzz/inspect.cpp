// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// A result.json as `inspect` reads it: beside a scene that it may not belong to.

#include "gestalt/inspector/inspection/inspection.h"

#include <nlohmann/json.hpp>

#include "gestalt/core/pipeline/pipeline.h"
#include "gestalt/io/result/result_file.h"
#include "scratch.h"

namespace {

using namespace gestalt;

/// A table with a box on it.
Input scene() {
  const Camera camera{32, 24, 40, 40, 16, 12};
  cv::Mat_<float> depth(camera.height, camera.width, 1.0F);
  depth(cv::Rect(8, 6, 12, 10)).setTo(0.9F);
  cv::Mat colour(depth.size(), CV_8UC3, cv::Scalar(200, 180, 160));
  colour(cv::Rect(8, 6, 12, 10)).setTo(cv::Scalar(30, 60, 220));
  Input input;
  input.frame = make_frame("scene", colour, depth, camera);
  return input;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt::fuzz;
  static const Scratch scratch;
  static const Input input = scene();
  static const Segmenter segmenter;
  return expect_result_or_error([&] {
    const nlohmann::json stored = read_result_content(scratch.write("result.json", text_of(data, size)));
    inspector_page({inspect_scene(stored, input, segmenter)});
  });
}
