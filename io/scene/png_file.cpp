// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "png_file.h"

#include <boost/crc.hpp>
#include <string>
#include <string_view>

#include "colour_image.h"
#include "deflate.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"
#include "gestalt/io/scene/png_codec.h"
#include "most_pixels.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t largest_png = std::uintmax_t{1} << 30;  // bytes
constexpr std::uint32_t longest_side = 1u << 20;                 // pixels

/// What the IHDR chunk declares (PNG specification, 11.2.2).
struct PngHeader {
  std::uint32_t width;
  std::uint32_t height;
  int bits;         ///< of one sample
  int colour_type;  ///< 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGB and alpha

  std::string pixels() const {
    const char* kind = colour_type == 0   ? "grey"
                       : colour_type == 2 ? "RGB"
                       : colour_type == 3 ? "palette"
                       : colour_type == 4 ? "grey with alpha"
                       : colour_type == 6 ? "RGB with alpha"
                                          : "unknown";
    return std::to_string(bits) + "-bit " + kind;
  }
};

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

[[noreturn]] void reject_png(const fs::path& file, const std::string& what) {
  throw InputError(file.string() + ": " + what);
}

/// Walks all chunks to the end marker and compares their checksums, so that the error can name the place.
PngHeader check_png(const fs::path& file, std::string_view bytes) {
  constexpr std::string_view signature("\x89PNG\r\n\x1a\n", 8);
  if (!bytes.starts_with(signature))
    reject_png(file,
               "is not a PNG image; convert it to PNG (depth: 16-bit grey, in the unit of depth_scale in camera.yaml)");
  PngHeader header{};
  for (std::size_t at = signature.size();;) {
    const auto truncated = [&] {
      reject_png(file, "is truncated or damaged at byte " + std::to_string(at) + " of " + std::to_string(bytes.size()) +
                           "; copy or write it again");
    };
    if (bytes.size() - at < 12) truncated();  // length, type, checksum
    const std::size_t length = big_endian(bytes, at);
    if (bytes.size() - at - 12 < length) truncated();
    boost::crc_32_type checksum;
    checksum.process_bytes(bytes.data() + at + 4, length + 4);
    if (checksum.checksum() != big_endian(bytes, at + 8 + length)) truncated();
    const std::string_view type = bytes.substr(at + 4, 4);
    if (at == signature.size()) {
      if (type != "IHDR" || length != 13) truncated();
      header = {big_endian(bytes, at + 8), big_endian(bytes, at + 12), bytes[at + 16], bytes[at + 17]};
    }
    at += length + 12;
    if (type == "IEND") break;
  }
  if (header.width == 0 || header.height == 0 || header.width > longest_side || header.height > longest_side ||
      std::int64_t{header.width} * header.height > most_pixels)
    reject_png(file, "declares " + std::to_string(header.width) + "x" + std::to_string(header.height) +
                         " pixels; images of 1 to 2^26 pixels can be read");
  constexpr std::uint64_t most_in_a_byte = 8 * most_inflated;  // of a bit each
  if (std::uint64_t{header.width} * header.height / most_in_a_byte > bytes.size())
    reject_png(file, "declares " + std::to_string(header.width) + "x" + std::to_string(header.height) +
                         " pixels, more than its " + std::to_string(bytes.size()) + " bytes can hold; write it again");
  return header;
}

cv::Mat decode(const fs::path& file, std::string_view bytes, const PngHeader& header, int type) {
  cv::Mat image(int(header.height), int(header.width), type);
  const std::string problem = decode_png(bytes, image);
  if (!problem.empty())
    reject_png(file, "cannot be decoded (" + problem + "); its pixel data are damaged, write it again");
  return image;
}

}  // namespace

cv::Mat colour_of_png(const fs::path& file, std::string_view bytes) {
  const PngHeader header = check_png(file, bytes);
  if (header.bits <= 8) return decode(file, bytes, header, CV_8UC3);
  std::string problem;
  cv::Mat colour = as_colour(decode(file, bytes, header, CV_16UC3), problem);
  if (!problem.empty()) reject_png(file, problem);
  return colour;
}

cv::Mat read_colour_png(const fs::path& file) { return colour_of_png(file, read_bytes(file, largest_png)); }

cv::Mat_<std::uint16_t> depth_of_png(const fs::path& file, std::string_view bytes) {
  const PngHeader header = check_png(file, bytes);
  if (header.bits != 16 || header.colour_type != 0)
    reject_png(file,
               "is " + header.pixels() +
                   ", depth must be 16-bit grey; save the sensor's depth as uint16 (millimetres, or another unit named "
                   "by depth_scale in camera.yaml), not a picture of it");
  return decode(file, bytes, header, CV_16UC1);
}

cv::Mat_<std::uint16_t> read_depth_png(const fs::path& file) {
  return depth_of_png(file, read_bytes(file, largest_png));
}

cv::Mat_<std::uint16_t> read_label_png(const fs::path& file) {
  const std::string bytes = read_bytes(file, largest_png);
  const PngHeader header = check_png(file, bytes);
  // Fewer bits are packed, several labels to a byte.
  if ((header.bits != 8 && header.bits != 16) || header.colour_type != 0)
    reject_png(file,
               "is " + header.pixels() + ", labels must be 8-bit or 16-bit grey; save the label numbers, not colours");
  cv::Mat_<std::uint16_t> labels;
  decode(file, bytes, header, header.bits == 8 ? CV_8UC1 : CV_16UC1).convertTo(labels, CV_16U);
  return labels;
}

}  // namespace gestalt
