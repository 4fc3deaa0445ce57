// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gestalt {

/// The images of one frame; empty where there is none.
struct FrameFiles {
  std::filesystem::path depth;
  std::filesystem::path colour;
};

/// Of a scene folder: depth, rgb (or color, colour), with any extension of an image file, in small letters or
/// capitals. Files whose names begin with a dot are passed over, here and below. Throws InputError where two files
/// could be the same image.
FrameFiles files_of_scene_folder(const std::filesystem::path& folder);

/// Whether a folder has a depth or colour image of such a name.
bool has_scene_images(const std::filesystem::path& folder);

/// The depth images of a recording, in natural order: those of its folder with "depth" in its name, else its images
/// with "depth" in their names. Empty: the folder is not a recording.
std::vector<std::filesystem::path> depth_images(const std::filesystem::path& folder);

/// The recording that a depth image lies in: the folder of its folder, where that is one of depth images
/// (with "depth" in its name), else its own.
std::filesystem::path recording_of(const std::filesystem::path& depth);

/// The files of the frame that a depth image is of. Its colour image, in this order: the one that lists of the
/// recording name (has_associations()); in a folder of the recording with rgb, color, colour or image in its name, the
/// one of the same name, or the only one of the same number; beside it, the one whose name has such a word where
/// depth's has "depth". Throws InputError where there are colour images, but none can be told to be its own.
FrameFiles files_of_frame(const std::filesystem::path& depth);

/// "rgb.jpg, notes.txt and 12 more are" of a folder, for messages that name what was found; "nothing is".
std::string seen_in(const std::filesystem::path& folder);

}  // namespace gestalt
