// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// Writes bytes under a temporary name beside the file and renames it: readers see the old file, the new one, or none.
/// Makes missing parent folders; a symbolic link stays and its file is replaced. Throws OutputError naming the file and
/// the system's reason, also where the name is taken by a folder or a device; leaves no temporary file.
GESTALT_EXPORT void write_file(const std::filesystem::path& file, std::string_view bytes);

/// A file to be, with its content.
struct OutputFile {
  std::filesystem::path file;
  std::string bytes;
};

/// write_file for files that belong together: none gets its final name before all are written. Where a name is a
/// symbolic link, the file takes its place: files in a folder may be named and put there by strangers.
GESTALT_EXPORT void write_files(const std::vector<OutputFile>& files);

/// The same with a file that tells that all others are there: the old one is removed before any other gets its final
/// name, the new one gets its own last. So the others belong to it wherever it is found, even when the process was
/// killed.
GESTALT_EXPORT void write_files(const std::vector<OutputFile>& files, const OutputFile& last);

/// Throws OutputError where a folder is a symbolic link: one that is named by data, as a scene's is, must not lead out
/// of the output folder.
GESTALT_EXPORT void refuse_link(const std::filesystem::path& folder);

/// Removes the temporary files that processes which were killed have left in a folder; nothing where there is none.
GESTALT_EXPORT void remove_abandoned(const std::filesystem::path& folder);

}  // namespace gestalt
