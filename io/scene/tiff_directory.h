// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>

namespace gestalt {

/// The unsigned number of up to four bytes at a place; 0 beyond the end.
std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t size, bool big_endian);

/// A number of the first directory of a TIFF file, or of EXIF data, which have that form, by its tag; 0 where it is not
/// there.
std::uint32_t tiff_value(std::string_view tiff, std::uint32_t tag);

}  // namespace gestalt
