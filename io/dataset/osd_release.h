// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gestalt/io/scene/converted_scene.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

// The Object Segmentation Database (OSD 0.2, Richtsfeld et al.) comes as image_color/NAME.png, disparity/NAME.png,
// annotation/NAME.png and pcd/NAME.pcd, NAME being learn0..44 or test0..65.

/// The names of all scenes of an original OSD release, in natural order: every PNG of its three folders, so that a
/// scene that lacks one of its images is reported when it is read. Throws InputError for a folder without them.
GESTALT_EXPORT std::vector<std::string> find_osd_scenes(const std::filesystem::path& release);

/// Reads one scene of an OSD release. disparity/ holds depth along the optical axis in millimetres, despite its name.
/// Without a camera in the options the database's (525 px, 640x480). Throws InputError naming the file and the remedy.
GESTALT_EXPORT ConvertedScene read_osd_scene(const std::filesystem::path& release, const std::string& name,
                                             const ReadOptions& options = {});

/// What the database's readme says of a scene's name, learnN or testN.
struct OsdScene {
  std::string set;       ///< "learn" or "test"; "scenes" for any other name
  std::string category;  ///< "boxes", ..., "complex_scene"; "" for any other name
};
GESTALT_EXPORT OsdScene osd_scene(std::string_view name);

}  // namespace gestalt
