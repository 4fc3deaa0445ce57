// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Folders of scenes and data sets in which some of the files that readers look for are there, each sound or arbitrary.

#include <fuzzer/FuzzedDataProvider.h>

#include <array>
#include <fstream>
#include <iterator>

#include "gestalt/io/dataset/bop_scene.h"
#include "gestalt/io/scene/input.h"
#include "scratch.h"

namespace {

namespace fs = std::filesystem;
using namespace gestalt;

constexpr std::array<const char*, 24> names{"depth.png",
                                            "rgb.png",
                                            "label.png",
                                            "camera.yaml",
                                            "camera_color.yaml",
                                            "extrinsics.txt",
                                            "cam_K.txt",
                                            "categories.csv",
                                            "associations.txt",
                                            "depth.txt",
                                            "rgb.txt",
                                            "cloud.pcd",
                                            "cloud.ply",
                                            "frame.npz",
                                            "scene_camera.json",
                                            "depth/000001.png",
                                            "rgb/000001.png",
                                            "rgb/000001.jpg",
                                            "mask_visib/000001_000000.png",
                                            "depth/1.exr",
                                            "below/depth.png",
                                            "below/rgb.png",
                                            "instances.json",
                                            "camera.json"};

// Sound files, as seeds of other targets.
constexpr std::array<const char*, 10> seeds{"camera/ours",     "camera/realsense", "pcd/organized", "ply/organized",
                                            "npz/plain",       "image/jpeg",       "bop/camera",    "recording/lists",
                                            "categories/list", "coco/list.json"};

std::string content(const char* seed) {
  std::ifstream in(std::string(FUZZ_CORPUS) + "/" + seed, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A PGM of 16 bits: images are known by their content, whatever their name.
std::string image(FuzzedDataProvider& provider) {
  const int width = provider.ConsumeIntegralInRange(1, 16), height = provider.ConsumeIntegralInRange(1, 12);
  std::string bytes = "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n65535\n";
  const std::string pixel{char(provider.ConsumeIntegralInRange(0, 9)), char(provider.ConsumeIntegral<std::uint8_t>())};
  for (int i = 0; i < width * height; ++i) bytes += pixel;
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt::fuzz;
  static const std::vector<std::string> sound = [] {
    std::vector<std::string> all;
    for (const char* seed : seeds) all.push_back(content(seed));
    return all;
  }();
  const Scratch scratch;
  fs::path root = scratch.write("sequence/.keep", "").parent_path();
  FuzzedDataProvider provider(data, size);
  for (int files = provider.ConsumeIntegralInRange(1, 8); files > 0; --files) {
    const std::string name = std::string("sequence/") + provider.PickValueInArray(names);
    switch (provider.ConsumeIntegralInRange(0, 3)) {
      case 0:
        scratch.write(name, provider.ConsumeRandomLengthString(2000));
        break;
      case 1:
        scratch.write(name, image(provider));
        break;
      default:
        scratch.write(name, sound[provider.ConsumeIntegralInRange<std::size_t>(0, sound.size() - 1)]);
    }
  }
  expect_result_or_error([&] {
    for (const fs::path& scene : find_scenes({root})) expect_result_or_error([&] { read_scene(scene); });
  });
  expect_result_or_error([&] { read_scene(root); });
  return expect_result_or_error([&] {
    for (const BopImage& found : find_bop_images(root)) expect_result_or_error([&] { read_bop_image(found); });
  });
}
