// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace gestalt {

/// The part of a cloud that a scene needs, in the order of the file (row by row for an organized cloud).
struct PointCloud {
  int width = 0;
  int height = 0;                                        ///< 1: unorganized, or an image of one row
  std::vector<cv::Vec3f> points;                         ///< metres; may hold NaN and infinite coordinates
  std::vector<cv::Vec3b> colours;                        ///< blue, green, red; empty when the cloud has no colour
  std::vector<std::uint16_t> labels;                     ///< empty when the cloud has no field label
  std::array<double, 7> viewpoint{0, 0, 0, 1, 0, 0, 0};  ///< as PcdHeader::viewpoint

  /// The point can be seen by the camera: its coordinates are finite and it lies before it.
  bool visible(std::size_t i) const;
};

// Both throw InputError naming the file, the place and the remedy. Not by PCL, which trusts the header and reports
// damage on stderr, and whose library of files brings sixty others with it.

/// Reads a PCD file of any data kind and field order: x, y, z (F, 4 or 8 bytes), rgb or rgba (4 bytes, packed), label
/// (whole numbers of any type). Colour may also be three fields (red green blue, r g b, diffuse_red and so on; bytes,
/// 16-bit whole numbers, or floats from 0 to 1), or the field intensity, as grey.
PointCloud read_pcd(const std::filesystem::path& file);

/// Reads the vertices of a PLY file with properties as the fields of a PCD file.
PointCloud read_ply(const std::filesystem::path& file);

/// A PCD file (0.7, binary): x y z, rgb where there are colours, label (U 4) where there are labels.
std::string encode_pcd(const PointCloud& cloud);

}  // namespace gestalt
