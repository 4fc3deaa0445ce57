// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// Writes bytes under a temporary name beside the file and renames it: readers see the old file, the new one, or none.
/// Makes missing parent folders; a symbolic link stays and its file is replaced. Throws OutputError naming the file and
/// the system's reason, also where the name is taken by a folder or a device; leaves no temporary file.
GESTALT_EXPORT void write_file(const std::filesystem::path& file, std::string_view bytes);

/// Where an output goes: what the user has named, whose links are followed, and the way from there, which data may
/// name, as a scene's name does. No link is followed on that way: a stranger may have put it there to lead out.
class GESTALT_EXPORT OutputPath {
 public:
  /// Implicit, so that what the user named can be given as it is.
  OutputPath(std::filesystem::path named) : named_(std::move(named)) {}  // NOLINT(google-explicit-constructor)

  /// What lies below.
  OutputPath operator/(const std::filesystem::path& name) const;

  std::filesystem::path path() const { return below_.empty() ? named_ : named_ / below_; }  // no "/" at the end
  const std::filesystem::path& named() const { return named_; }
  const std::filesystem::path& below() const { return below_; }

 private:
  std::filesystem::path named_, below_;
};

/// A file to be, with its content.
struct OutputFile {
  OutputPath file;
  std::string bytes;
};

/// write_file for files that belong together: none gets its final name before all are written. Missing folders are
/// made. Where the file's name is a symbolic link, the file takes its place; where a folder below what the user named
/// is one, throws OutputError. Folders are opened one below the other, so that none can be made a link meanwhile.
/// Others that write files into the same folders by these functions - threads, processes - wait until all have their
/// names, 30 s at most, after which they throw OutputError with the process that holds the lock.
GESTALT_EXPORT void write_files(const std::vector<OutputFile>& files);

/// The same with a file that tells that all others are there: the old one is removed before any other gets its final
/// name, the new one gets its own last. So the others belong to it wherever it is found, even when the process was
/// killed. outdated gives the names beside it of files that belong to the old one, and are removed with that; it is
/// called while no one else changes files of the folder by these functions.
GESTALT_EXPORT void write_files(const std::vector<OutputFile>& files, const OutputFile& last,
                                const std::function<std::vector<std::string>()>& outdated = {});

/// write_files for a file that follows from what was there: content is called, and reads that, while no one else
/// changes files of the folder by these functions.
GESTALT_EXPORT void update_file(const OutputPath& file, const std::function<std::string()>& content);

/// Removes the temporary files that processes which were killed have left in a folder, .gestalt-<16 digits>.tmp;
/// nothing where there is none, or a link on the way below what the user named. Those that are being written have a
/// lock, which other containers and machines see, too.
GESTALT_EXPORT void remove_abandoned(const OutputPath& folder);

}  // namespace gestalt
