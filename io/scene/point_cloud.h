// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace gestalt {

/// The part of a cloud that a scene needs, in the order of the file (row by row for an organized cloud).
struct PointCloud {
  int width = 0;
  int height = 0;                     ///< 1: unorganized, or an image of one row
  std::vector<cv::Vec3f> points;      ///< metres, camera frame; may hold NaN and infinite coordinates
  std::vector<cv::Vec3b> colours;     ///< blue, green, red; empty when the cloud has no field rgb or rgba
  std::vector<std::uint16_t> labels;  ///< empty when the cloud has no field label

  /// The point can be seen by the camera: its coordinates are finite and it lies before it.
  bool visible(std::size_t i) const;
};

// Both throw InputError naming the file, the place and the remedy. Not by PCL, which trusts the header and reports
// damage on stderr, and whose library of files brings sixty others with it.

/// Reads a PCD file of any data kind and field order: x, y, z (F, 4 or 8 bytes), rgb or rgba (4 bytes), label (I or U).
PointCloud read_pcd(const std::filesystem::path& file);

/// Reads a PLY file with vertices of x, y, z (float or double), red, green, blue (uchar), label (a whole number).
PointCloud read_ply(const std::filesystem::path& file);

/// A PCD file (0.7, binary): x y z, rgb where there are colours, label (U 4) where there are labels.
std::string encode_pcd(const PointCloud& cloud);

}  // namespace gestalt
