// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/surface_model.h"

#include <nlohmann/json.hpp>

namespace gestalt {

SurfaceModel::~SurfaceModel() = default;

float SurfaceModel::squared_distance(const Eigen::Vector3f& p) const { return (foot(p).point - p).squaredNorm(); }

std::optional<Eigen::Vector2d> SurfaceModel::parameters(const Eigen::Vector3f&) const { return std::nullopt; }

}  // namespace gestalt
