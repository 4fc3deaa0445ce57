// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gestalt/io/scene/converted_scene.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

/// A frame of the Object Cluttered Indoor Dataset (OCID).
struct OcidFrame {
  std::filesystem::path sequence;
  std::filesystem::path depth;
  std::string name;  ///< the way to the sequence, and that of the image
};

/// The frames of all sequences in a folder: folders that hold depth and label. Throws InputError.
GESTALT_EXPORT std::vector<OcidFrame> find_ocid_frames(const std::filesystem::path& release);

/// Depth is in millimetres. Labels 0 and 1 are background, as is 2 where "table" is in the path of the sequence; the
/// others are objects. Without a camera in the options that of the points in pcd/. Throws InputError.
GESTALT_EXPORT ConvertedScene read_ocid_frame(const OcidFrame& frame, const ReadOptions& options = {});

}  // namespace gestalt
