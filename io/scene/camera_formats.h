// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "camera_entries.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

// Intrinsics as programs write them. What is read has the size 0x0 where the file names none, and no value is checked
// beyond what its reader says.

/// A file of keys and values: YAML, JSON, or OpenCV's XML.
struct CameraFormat {
  std::string name;  ///< for messages, and a row of docs/formats.md
  std::string keys;  ///< for messages: what it has
  std::function<bool(const CameraEntries&)> recognises;
  std::function<CameraFile(CameraEntries&)> read;  ///< what is wrong is kept in the entries
};

/// In the order in which they are tried; the last one is our own.
std::span<const CameraFormat> camera_formats();

/// A file of plain text.
struct CameraTextFormat {
  std::string name;
  std::string keys;
  bool (*recognises)(std::string_view text);
  CameraFile (*read)(const std::filesystem::path& file, std::string_view text);  ///< throws InputError
};

std::span<const CameraTextFormat> camera_text_formats();

/// Of ICL-NUIM and others whose y axis points up while their images are as all are.
inline constexpr const char* negative_fy_note =
    "fy is negative, as where the y axis points up; it is taken as positive";

/// The intrinsics of a matrix of 3x3, 3x4 or 4x4 numbers, row by row or, where its last column tells so, column by
/// column. Returns what is wrong, "" when nothing is; a negative fy is taken as positive, with a note.
std::string take_matrix(std::span<const double> numbers, CameraFile& result);

}  // namespace gestalt
