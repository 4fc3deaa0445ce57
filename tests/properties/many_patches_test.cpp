// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// As many patches as a 16-bit image has labels, and more.

#include <gtest/gtest.h>

#include "cases.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/pipeline/segmenter.h"

namespace gestalt::properties {
namespace {

/// Single pixels, each a step away from those beside it.
Frame lonely_pixels(cv::Size size) {
  cv::Mat_<float> depth(size);
  for (int v = 0; v < size.height; ++v)
    for (int u = 0; u < size.width; ++u) depth(v, u) = 1 + float((u + 2 * v) % 4);
  return make_frame("lonely pixels", cv::Mat(size, CV_8UC3, cv::Scalar(90, 120, 150)), depth,
                    {size.width, size.height, 525, 525, size.width / 2.0, size.height / 2.0});
}

/// A patch of every pixel, whatever a clusterer would make.
struct EveryPixel final : Clusterer {
  PatchMap cluster(const Frame& frame) const override {
    PatchMap patches{cv::Mat_<int>(frame.depth.size()), cv::Mat_<cv::Vec3f>(frame.depth.size(), cv::Vec3f(0, 0, -1)),
                     int(frame.depth.total())};
    int next = 0;
    for (int& label : patches.labels) label = ++next;
    return patches;
  }
};

Registry with_every_pixel() {
  Registry registry(plugin_search_path({}));
  registry.add<Clusterer>({"clusterer", "every_pixel", "1.0.0", "A patch of every pixel", {}},
                          {{}, [](const ParameterValues&) { return std::make_unique<EveryPixel>(); }});
  return registry;
}

Segmenter every_pixel_segmenter() {
  return Segmenter(LoadedConfig(
      ConfigTree(default_config(), {"signal.clusterer=every_pixel", "structural.minimum_size=1"}), with_every_pixel()));
}

TEST(ManyPatches, ThatALabelImageHoldsAreSegmented) {
  const Segmenter gestalt = every_pixel_segmenter();
  const Frame frame = lonely_pixels({257, 255});
  ASSERT_EQ(frame.depth.total(), 65'535u);
  const SegmentedFrame found = gestalt.segment(frame);
  EXPECT_EQ(found.percept.surfaces().surfaces.size(), 65'535u);
  EXPECT_EQ(cv::countNonZero(found.segmentation.labels), 65'535);
}

TEST(ManyPatches, ThatNoLabelImageHoldsAreRefused) {
  const Segmenter gestalt = every_pixel_segmenter();
  const Percept percept = gestalt.pipeline().perceive(lonely_pixels({257, 256}));
  try {
    gestalt.pipeline().decide(percept, gestalt.models());
    FAIL() << "65792 segments in a 16-bit image";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("a 16-bit label image holds at most 65535"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace gestalt::properties
