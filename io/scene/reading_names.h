// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "gestalt/io/scene/input.h"

namespace gestalt {

// What users call the values of ReadOptions: --depth-kind and --labels of the command, depth_kind= and labels= in
// Python.

inline constexpr std::array<std::pair<std::string_view, DepthKind>, 3> depth_kinds{
    {{"plain", DepthKind::plain}, {"radial", DepthKind::radial}, {"rotated", DepthKind::rotated}}};

/// "parts" is what --labels of convert called it first.
inline constexpr std::array<std::pair<std::string_view, LabelScheme>, 4> label_schemes{
    {{"osd", LabelScheme::osd},
     {"objects", LabelScheme::objects},
     {"colours", LabelScheme::colours},
     {"parts", LabelScheme::osd}}};

}  // namespace gestalt
