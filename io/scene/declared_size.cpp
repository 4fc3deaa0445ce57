// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "declared_size.h"

#include <charconv>
#include <cstdint>
#include <limits>
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

/// The value of an attribute of the first part, whose attributes are: name, type, size of the value, value. Nothing
/// where it is not there or any of them is damaged: OpenEXR takes memory for what any claims.
std::optional<std::string_view> exr_attribute(std::string_view bytes, std::string_view wanted) {
  bytes.remove_prefix(std::min<std::size_t>(8, bytes.size()));
  std::optional<std::string_view> found;
  while (!bytes.empty() && bytes[0] != '\0') {
    const std::size_t name = bytes.find('\0');
    const std::size_t type = name == bytes.npos ? name : bytes.find('\0', name + 1);
    if (type == bytes.npos || bytes.size() - type < 5) return std::nullopt;
    const std::size_t size = number_at(bytes, type + 1, 4, false), value = type + 5;
    if (bytes.size() - value < size) return std::nullopt;
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

std::size_t exr_channels(std::string_view bytes) {
  constexpr std::size_t entry = 16;  // type, and what else is said of a channel, behind its name
  std::string_view list = exr_attribute(bytes, "channels").value_or("");
  std::size_t count = 0;
  for (; !list.empty() && list[0] != '\0'; ++count)
    list.remove_prefix(std::min(list.size(), std::min(list.find('\0'), list.size()) + 1 + entry));
  return count;
}

}  // namespace gestalt
