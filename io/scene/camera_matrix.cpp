// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include "camera_formats.h"

namespace gestalt {

std::string take_matrix(std::span<const double> numbers, CameraFile& result) {
  if (numbers.size() != 9 && numbers.size() != 12 && numbers.size() != 16)
    return "must have 9 numbers (3x3), 12 (3x4) or 16 (4x4), it has " + std::to_string(numbers.size());
  const std::size_t columns = numbers.size() == 9 ? 3 : 4;
  const auto written = [&](std::size_t row, std::size_t column) { return numbers[row * columns + column]; };
  const bool by_columns = written(0, 2) == 0 && written(1, 2) == 0 && (written(2, 0) != 0 || written(2, 1) != 0);
  const auto at = [&](std::size_t row, std::size_t column) {
    return by_columns ? written(column, row) : written(row, column);
  };
  if (at(2, 0) != 0 || at(2, 1) != 0 || at(2, 2) != 1) return "must have the row 0 0 1: fx 0 cx, 0 fy cy, 0 0 1";
  if (at(1, 0) != 0 || std::abs(at(0, 1)) > 1e-3 * std::abs(at(0, 0))) return "has skewed axes, which is not supported";
  Camera& camera = result.camera;
  camera.fx = at(0, 0), camera.fy = at(1, 1), camera.cx = at(0, 2), camera.cy = at(1, 2);
  if (camera.fx > 0 && camera.fy < 0) {
    camera.fy = -camera.fy;
    result.notes.push_back(negative_fy_note);
  }
  return "";
}

}  // namespace gestalt
