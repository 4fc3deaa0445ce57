// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// A scene folder with the input as its depth.png, of the size that its header tells; then as its rgb.png and label.png,
// beside a depth image of that size.

#include <zlib.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "gestalt/io/scene/input.h"
#include "scratch.h"

namespace {

using gestalt::fuzz::Scratch;

constexpr std::size_t signature = 8, frame_of_chunk = 12;  // length and type before the data, checksum after it

std::uint32_t big_endian(const std::uint8_t* bytes) {
  return std::uint32_t(bytes[0]) << 24 | std::uint32_t(bytes[1]) << 16 | std::uint32_t(bytes[2]) << 8 | bytes[3];
}

std::string camera_for(std::uint32_t width, std::uint32_t height) {
  const std::string w = std::to_string(width), h = std::to_string(height);
  return "width: " + w + "\nheight: " + h + "\nfx: 525\nfy: 525\ncx: 0\ncy: 0\n";
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

/// Mends the checksums of all chunks: behind a wrong one nothing more is read.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned int /*seed*/) {
  size = LLVMFuzzerMutate(data, size, most);
  for (std::size_t at = signature; at + frame_of_chunk <= size;) {
    const std::size_t length = big_endian(data + at);
    if (length > size - at - frame_of_chunk) break;
    const auto sum = std::uint32_t(crc32(0, data + at + 4, uInt(length + 4)));
    for (int i = 0; i < 4; ++i) data[at + 8 + length + std::size_t(i)] = std::uint8_t(sum >> (24 - 8 * i));
    at += frame_of_chunk + length;
  }
  return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt;
  using namespace gestalt::fuzz;
  static const Scratch scratch;
  if (size < 24) return 0;
  const std::string_view bytes = text_of(data, size);
  const std::string camera = camera_for(big_endian(data + 16), big_endian(data + 20));
  scratch.write("depth/camera.yaml", camera);
  const std::filesystem::path depth = scratch.write("depth/depth.png", bytes);
  expect_result_or_error([&] { read_scene(depth.parent_path()); });
  static const bool surroundings = [] {
    std::vector<std::uint8_t> depth_png;
    cv::imencode(".png", cv::Mat_<std::uint16_t>(3, 4, std::uint16_t(900)), depth_png);
    for (const std::string name : {"rgb", "label"}) {
      scratch.write(name + "/camera.yaml", "width: 4\nheight: 3\nfx: 5\nfy: 5\ncx: 2\ncy: 1\n");
      scratch.write(name + "/depth.png", text_of(depth_png.data(), depth_png.size()));
    }
    return true;
  }();
  (void)surroundings;
  for (const std::string name : {"rgb", "label"}) {
    const std::filesystem::path image = scratch.write(std::filesystem::path(name) / (name + ".png"), bytes);
    expect_result_or_error([&] { read_scene(image.parent_path()); });
  }
  return 0;
}
