// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "gestalt/io/scene/converted_scene.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

/// Reads a PCD file as read_scene() does. Without a field label the scene has no labels. Throws InputError, also for
/// labels that name no object.
GESTALT_EXPORT ConvertedScene read_labelled_cloud(const std::filesystem::path& file, const ReadOptions& options = {});

}  // namespace gestalt
