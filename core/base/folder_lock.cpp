// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include "gestalt/core/base/error.h"

namespace gestalt {

namespace {

/// The file's device and number, as /proc/locks has it.
std::string place_of(int file) {
  struct stat status {};
  if (::fstat(file, &status) != 0) return {};
  char text[64];
  std::snprintf(text, sizeof(text), "%02x:%02x:%llu", ::major(status.st_dev), ::minor(status.st_dev),
                static_cast<unsigned long long>(status.st_ino));
  return text;
}

/// "process 17", where the system tells it: it does not know those of other machines and containers.
std::string holder_of(int file) {
  const std::string place = place_of(file);
  std::ifstream locks("/proc/locks");
  for (std::string line; std::getline(locks, line);) {
    std::istringstream words(line);
    std::string number, kind, mode, access, process, where;
    if (words >> number >> kind >> mode >> access >> process >> where && kind == "FLOCK" && where == place)
      return "process " + process;
  }
  return "a process of another container or machine";
}

}  // namespace

bool try_lock(int file) { return ::flock(file, LOCK_EX | LOCK_NB) == 0; }

// The folder is opened again, as the lock belongs to the open file: two threads with one descriptor would both have it.
FolderLock::FolderLock(int folder, const std::filesystem::path& path, std::chrono::milliseconds most)
    : folder_(::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  constexpr std::chrono::milliseconds between{1};
  const auto end = std::chrono::steady_clock::now() + most;
  while (folder_ && !try_lock(folder_)) {
    if (errno != EWOULDBLOCK && errno != EINTR) return;
    if (std::chrono::steady_clock::now() > end)
      throw OutputError((path.empty() ? "." : path.string()) + ": " + holder_of(folder_) +
                        " is writing to it; wait for it to finish, or choose another --output");
    std::this_thread::sleep_for(between);
  }
}

FolderLock::~FolderLock() {
  // A process that was forked meanwhile has the descriptor, too, and would keep the lock.
  if (folder_) ::flock(folder_, LOCK_UN);
}

}  // namespace gestalt
