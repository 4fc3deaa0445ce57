// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "gestalt/core/pipeline/pipeline.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

/// The images of a scene as data URIs of PNG files, every step-th pixel of every step-th row, step chosen so that at
/// most a million are left:
/// * "colour", as it is, or null;
/// * "depth" in units of "depth_unit" metres (0: none), "patches" (1 + index; 0: none) and, where there is ground
///   truth, "truth" (see object_of_label(); else null): numbers of 16 bits, the high byte in red and the low one in
///   green;
/// * "normals" of the fitted surfaces: to the right, upwards and to the camera, each of [-1, 1], in red, green and
///   blue; black where there is none.
nlohmann::json scene_images(const Input& input, const Percept& percept);

}  // namespace gestalt
