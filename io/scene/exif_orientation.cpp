// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "exif_orientation.h"

#include "declared_size.h"
#include "tiff_directory.h"

namespace gestalt {

namespace {

using namespace std::string_view_literals;

/// Segments: 0xff, a marker, the length with its own two bytes, the content. Pixels begin behind SOS.
std::string_view exif_of_jpeg(std::string_view bytes) {
  constexpr std::uint32_t app1 = 0xffe1, start_of_scan = 0xffda;
  constexpr std::string_view name = "Exif\0\0"sv;
  for (std::size_t at = 2; at + 4 <= bytes.size();) {
    const std::uint32_t marker = number_at(bytes, at, 2, true), length = number_at(bytes, at + 2, 2, true);
    if (marker < 0xff00 || marker == start_of_scan || length < 2) break;
    const std::string_view content = bytes.substr(at + 4, length - 2);
    if (marker == app1 && content.starts_with(name)) return content.substr(name.size());
    at += 2 + length;
  }
  return {};
}

/// Chunks: the length of the content, a type, the content, a checksum.
std::string_view exif_of_png(std::string_view bytes) {
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const std::size_t length = number_at(bytes, at, 4, true);
    if (bytes.substr(at + 4, 4) == "eXIf") return bytes.substr(at + 8, length);
    at += 12 + length;
  }
  return {};
}

}  // namespace

int stored_orientation(std::string_view bytes) {
  constexpr std::uint32_t orientation_tag = 274;
  const ImageKind kind = image_kind(bytes);
  const std::string_view exif = kind == ImageKind::jpeg  ? exif_of_jpeg(bytes)
                                : kind == ImageKind::png ? exif_of_png(bytes)
                                                         : std::string_view();
  const std::uint32_t orientation = tiff_value(exif, orientation_tag);
  return orientation >= 2 && orientation <= 8 ? int(orientation) : 1;
}

}  // namespace gestalt
