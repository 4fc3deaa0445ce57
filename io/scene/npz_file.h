// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace gestalt {

/// An array of numpy, in C order.
struct NpyArray {
  char kind = 0;  ///< u, i, f or b, as numpy's dtype.kind
  int size = 0;   ///< bytes of an element
  std::vector<std::size_t> shape;
  std::string bytes;  ///< little-endian

  std::size_t count() const;

  /// An element as double; exact for all but large integers.
  double at(std::size_t index) const;
};

/// The arrays of a .npz file (as numpy.savez or savez_compressed writes it) that have one of these names; those in
/// Fortran order or big-endian are turned. Throws InputError naming the file and the array: for what is no such file,
/// for arrays of objects, and, before memory is taken for them, for arrays of more than 2^30 bytes together or more
/// than their packed bytes can be.
std::map<std::string, NpyArray> read_npz(const std::filesystem::path& file, std::span<const std::string> names);

/// The array of a .npy file, as numpy.save writes it. Throws InputError as read_npz() does.
NpyArray read_npy(const std::filesystem::path& file);

/// The bytes of a compressed .npz file. Arrays by their names. Throws OutputError.
std::string encode_npz(const std::map<std::string, NpyArray>& arrays);

}  // namespace gestalt
