// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace gestalt {

/// The numbers of a text file, between spaces, commas, semicolons and brackets. Throws InputError with the line.
std::vector<double> read_numbers(const std::filesystem::path& file);

}  // namespace gestalt
