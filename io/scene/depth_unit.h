// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "gestalt/io/scene/input.h"

namespace gestalt {

/// A length for each unit of a file's numbers.
struct DepthUnit {
  double metres = 1;
  std::string from;   ///< who tells it: "the default", "camera.yaml", ...
  bool told = false;  ///< by ReadOptions: it is not doubted
};

/// Metres of "mm", "0.1mm", "m", "cm", "um", ...: a number, where it is not 1, and a unit of length. Nothing for what
/// is none, or is beyond [1e-9, 1e4] m.
GESTALT_EXPORT std::optional<double> metres_of_unit(std::string_view text);

/// As a person writes it: "mm", "0.25 mm", "m"; 0.0003 m is "0.3 mm".
GESTALT_EXPORT std::string unit_name(double metres);

/// "0.001 m, the default".
std::string text(const DepthUnit& unit);

/// Of whole numbers: that of the options, else of the camera file (given or found), else a millimetre.
GESTALT_EXPORT DepthUnit unit_of_whole_numbers(const ReadOptions& options, const std::optional<CameraFile>& camera);

/// Of floats and clouds: that of the options, else a metre.
GESTALT_EXPORT DepthUnit unit_of_floats(const ReadOptions& options);

}  // namespace gestalt
