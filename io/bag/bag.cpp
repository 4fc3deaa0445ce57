// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/bag/bag.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "bag_file.h"
#include "decompression.h"
#include "gestalt/core/base/error.h"

namespace gestalt {

namespace fs = std::filesystem;

Bag::~Bag() = default;

BagFile::BagFile(fs::path file)
    : file_(std::move(file)), descriptor_(::open(file_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  struct stat status {};
  if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0)
    throw InputError(file_.string() + ": cannot be opened: " + std::strerror(errno));
  if (!S_ISREG(status.st_mode)) {
    ::close(descriptor_);
    throw InputError(file_.string() + ": is not a regular file");
  }
  size_ = std::uint64_t(status.st_size);
}

BagFile::~BagFile() { ::close(descriptor_); }

std::string BagFile::read(std::uint64_t place, std::uint64_t count) const {
  if (place > size_ || count > size_ - place)
    fail(place, "a length of " + std::to_string(count) + " bytes reaches beyond the end of the file");
  if (count > largest_chunk) fail(place, "a record of " + std::to_string(count) + " bytes is larger than 256 MiB");
  std::string bytes(std::size_t(count), '\0');
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t got = ::pread(descriptor_, bytes.data() + done, bytes.size() - done, off_t(place + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) fail(place + done, got < 0 ? std::string("cannot be read: ") + std::strerror(errno) : "ends here");
    done += std::size_t(got);
  }
  return bytes;
}

void BagFile::fail(std::uint64_t place, const std::string& what) const {
  throw InputError(file_.string() + ": byte " + std::to_string(place) + ": " + what);
}

std::string message_type(std::string_view name) {
  std::string type(name);
  if (const std::size_t infix = type.find("/msg/"); infix != type.npos) type.erase(infix, 4);
  return type;
}

namespace {

/// The recordings in a folder that rosbag2 has written; none in other folders.
std::vector<fs::path> recordings_of_rosbag2(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> files;
  if (!fs::is_regular_file(folder / "metadata.yaml", ignored)) return files;
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end; entry.increment(ignored))
    if (const fs::path extension = entry->path().extension(); extension == ".db3" || extension == ".mcap")
      files.push_back(entry->path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

bool is_bag(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return !recordings_of_rosbag2(path).empty();
  if (!fs::is_regular_file(path, ignored) || fs::file_size(path, ignored) < sqlite_magic.size()) return false;
  const std::string begin = BagFile(path).read(0, sqlite_magic.size());
  return begin.starts_with(ros1_magic) || begin.starts_with(mcap_magic) || begin == sqlite_magic;
}

std::unique_ptr<Bag> open_bag(const fs::path& path, const Bag::Take& take) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    const std::vector<fs::path> files = recordings_of_rosbag2(path);
    if (files.size() == 1) return open_bag(files.front(), take);
    throw InputError(path.string() + (files.empty()
                                          ? ": is a folder without a recording of rosbag2"
                                          : ": has " + std::to_string(files.size()) +
                                                " recordings; give one of them, as " + files.front().string()));
  }
  const BagFile opened(path);
  const std::string begin = opened.read(0, std::min<std::uint64_t>(opened.size(), sqlite_magic.size()));
  std::unique_ptr<Bag> bag;
  if (begin.starts_with(ros1_magic)) bag = make_ros1_bag(path);
  if (begin.starts_with(mcap_magic)) bag = make_mcap_bag(path);
  if (begin == sqlite_magic) bag = make_sqlite_bag(path);
  if (!bag && begin.starts_with("#ROSBAG"))
    throw InputError(path.string() + ": is a bag of an old version; run `rosbag fix` to make it version 2.0");
  if (!bag) throw InputError(path.string() + ": is not a recording of ROS (.bag of ROS 1, .mcap, or .db3 of rosbag2)");
  bag->scan(take);
  return bag;
}

}  // namespace gestalt
