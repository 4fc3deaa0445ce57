// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <filesystem>

#include "descriptor.h"
#include "gestalt/core/base/export.h"

namespace gestalt {

/// The right to change files of a folder that belong together, which one thread of one process has at a time. It is the
/// system's lock of the folder itself: it ends with the process, however that ends, and leaves nothing behind. Where
/// the file system has no locks there is none; digests in results tell of a mixture then.
class GESTALT_EXPORT FolderLock {
 public:
  static constexpr std::chrono::seconds patience{30};

  /// Waits for the right. Throws OutputError, with the folder's path and who has it, when patience ends.
  FolderLock(int folder, const std::filesystem::path& path, std::chrono::milliseconds most = patience);
  FolderLock(FolderLock&&) = default;
  ~FolderLock();

 private:
  Descriptor folder_;
};

/// Takes the lock of a file, for as long as it is open. False: somebody else has it (EWOULDBLOCK), or there are none.
bool try_lock(int file);

}  // namespace gestalt
