// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "declared_size.h"

#include <charconv>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "tiff_directory.h"

namespace gestalt {

namespace {

using namespace std::string_view_literals;

std::optional<cv::Size> size_of(std::int64_t width, std::int64_t height) {
  constexpr std::int64_t most = std::numeric_limits<int>::max();
  if (width < 1 || height < 1 || width > most || height > most) return std::nullopt;
  return cv::Size(int(width), int(height));
}

/// The first directory of the file, which is what is decoded.
std::optional<cv::Size> tiff_size(std::string_view bytes) {
  return size_of(tiff_value(bytes, 256), tiff_value(bytes, 257));
}

/// Width and height are the first numbers behind the two letters; # begins a comment.
std::optional<cv::Size> pnm_size(std::string_view bytes) {
  bytes.remove_prefix(2);
  const auto next = [&]() -> std::int64_t {
    for (;;) {
      bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
      if (!bytes.starts_with('#')) break;
      bytes.remove_prefix(std::min(bytes.find('\n'), bytes.size()));
    }
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(bytes.data(), bytes.data() + bytes.size(), value);
    if (error != std::errc{}) return 0;
    bytes.remove_prefix(std::size_t(end - bytes.data()));
    return value;
  };
  const std::int64_t width = next();
  return size_of(width, next());
}

/// Bytes that OpenEXR reads for a value of a type that has a fixed size; of others, which it reads by the declared
/// size, nothing.
std::optional<std::size_t> exr_value_size(std::string_view type) {
  static const std::map<std::string_view, std::size_t> sizes{{"box2f", 16},
                                                             {"box2i", 16},
                                                             {"chromaticities", 32},
                                                             {"compression", 1},
                                                             {"deepImageState", 1},
                                                             {"double", 8},
                                                             {"envmap", 1},
                                                             {"float", 4},
                                                             {"int", 4},
                                                             {"keycode", 28},
                                                             {"lineOrder", 1},
                                                             {"m33d", 72},
                                                             {"m33f", 36},
                                                             {"m44d", 128},
                                                             {"m44f", 64},
                                                             {"rational", 8},
                                                             {"tiledesc", 9},
                                                             {"timecode", 8},
                                                             {"v2d", 16},
                                                             {"v2f", 8},
                                                             {"v2i", 8},
                                                             {"v3d", 24},
                                                             {"v3f", 12},
                                                             {"v3i", 12}};
  const auto found = sizes.find(type);
  return found == sizes.end() ? std::nullopt : std::optional(found->second);
}

constexpr std::size_t exr_channel_size = 16;  // of what follows a channel's name

/// How many channels a list has; nothing when it does not end with its value, as OpenEXR reads it to its end.
std::optional<std::size_t> exr_channel_count(std::string_view list) {
  for (std::size_t count = 0; !list.empty(); ++count) {
    const std::size_t name = list.find('\0');
    if (name == 0) return list.size() == 1 ? std::optional(count) : std::nullopt;
    if (name == list.npos || list.size() - name <= exr_channel_size) return std::nullopt;
    list.remove_prefix(name + 1 + exr_channel_size);
  }
  return std::nullopt;
}

/// Whether OpenEXR reads exactly the declared bytes of a value. Where it reads others, it takes what follows for
/// attributes, and memory for whatever those claim.
bool exr_value_fits(std::string_view type, std::string_view value) {
  if (type == "chlist") return exr_channel_count(value).has_value();
  if (type == "preview")
    return value.size() >= 8 &&
           std::uint64_t(number_at(value, 0, 4, false)) * number_at(value, 4, 4, false) == (value.size() - 8) / 4 &&
           value.size() % 4 == 0;
  if (type == "stringvector") {
    while (value.size() >= 4 && number_at(value, 0, 4, false) <= value.size() - 4)
      value.remove_prefix(4 + number_at(value, 0, 4, false));
    return value.empty();
  }
  return value.size() == exr_value_size(type).value_or(value.size());
}

/// The value of an attribute of a file with one part, whose attributes are: name, type, size of the value, value.
/// Nothing where it is not there or any of them is damaged: OpenEXR takes memory for what any claims.
std::optional<std::string_view> exr_attribute(std::string_view bytes, std::string_view wanted) {
  if (!is_flat_exr(bytes)) return std::nullopt;
  bytes.remove_prefix(8);
  std::optional<std::string_view> found;
  while (!bytes.empty() && bytes[0] != '\0') {
    const std::size_t name = bytes.find('\0');
    const std::size_t type = name == bytes.npos ? name : bytes.find('\0', name + 1);
    if (type == bytes.npos || bytes.size() - type < 5) return std::nullopt;
    const std::size_t size = number_at(bytes, type + 1, 4, false), value = type + 5;
    if (bytes.size() - value < size ||
        !exr_value_fits(bytes.substr(name + 1, type - name - 1), bytes.substr(value, size)))
      return std::nullopt;
    if (bytes.substr(0, name) == wanted) found = bytes.substr(value, size);
    bytes.remove_prefix(value + size);
  }
  return bytes.empty() ? std::nullopt : found;
}

std::optional<cv::Size> exr_size(std::string_view bytes) {
  const auto window = exr_attribute(bytes, "dataWindow");
  if (!window || window->size() != 16) return std::nullopt;
  const auto corner = [&](std::size_t i) { return std::int64_t(std::int32_t(number_at(*window, 4 * i, 4, false))); };
  return size_of(corner(2) - corner(0) + 1, corner(3) - corner(1) + 1);
}

}  // namespace

ImageKind image_kind(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv)) return ImageKind::png;
  if (bytes.starts_with("\xff\xd8\xff"sv)) return ImageKind::jpeg;
  if (bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv)) return ImageKind::tiff;
  if (bytes.starts_with("\x76\x2f\x31\x01"sv)) return ImageKind::exr;
  if (bytes.starts_with("\x93NUMPY"sv)) return ImageKind::npy;
  if (bytes.size() > 2 && bytes[0] == 'P' && " \t\r\n#"sv.find(bytes[2]) != bytes.npos) {
    if ("2356"sv.find(bytes[1]) != bytes.npos) return ImageKind::pnm;
    if (bytes[1] == 'f' || bytes[1] == 'F') return ImageKind::pfm;
  }
  return ImageKind::unknown;
}

std::string seen_as(std::string_view bytes) {
  if (bytes.empty()) return " (it is empty)";
  static const std::vector<std::pair<std::string_view, std::string>> kinds{
      {"PK\x03\x04", "a ZIP archive, as .npz is"},
      {"GIF8", "a GIF image"},
      {"BM", "a BMP image"},

      {"%PDF", "a PDF document"},
      {"\x1f\x8b", "a gzip archive"},
      {"II+\0"sv, "a BigTIFF image"},
      {"MM\0+"sv, "a BigTIFF image"},
      {"version https://git-lfs", "a pointer of Git LFS, not the file; run git lfs pull"}};
  for (const auto& [begin, kind] : kinds)
    if (bytes.starts_with(begin)) return " (it is " + kind + ")";
  if (bytes.substr(0, 4) == "RIFF" && bytes.size() > 12 && bytes.substr(8, 4) == "WEBP") return " (it is a WebP image)";
  if (bytes.size() > 12 && bytes.substr(4, 4) == "ftyp") return " (it is a HEIC or AVIF image, as of telephones)";
  return "";
}

std::optional<cv::Size> declared_size(std::string_view bytes, ImageKind kind) {
  switch (kind) {
    case ImageKind::tiff:
      return tiff_size(bytes);
    case ImageKind::pnm:
    case ImageKind::pfm:
      return pnm_size(bytes);
    case ImageKind::exr:
      return exr_size(bytes);
    default:
      return std::nullopt;
  }
}

bool is_flat_exr(std::string_view bytes) {
  constexpr unsigned deep = 0x8, several_parts = 0x10;
  return bytes.size() > 8 && (std::uint8_t(bytes[5]) & (deep | several_parts)) == 0;
}

std::size_t exr_channels(std::string_view bytes) {
  return exr_channel_count(exr_attribute(bytes, "channels").value_or("")).value_or(0);
}

}  // namespace gestalt
