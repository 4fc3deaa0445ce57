// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "line_source.h"

#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstring>

#include "gestalt/core/base/error.h"

namespace gestalt::app {

namespace fs = std::filesystem;

LineSource::~LineSource() { ::close(file_); }

std::optional<std::vector<fs::path>> LineSource::next(std::size_t at_most) {
  std::vector<fs::path> paths;
  split(paths, at_most);
  for (auto wait = patience; paths.size() < at_most && !ended_ && readable(wait); wait = wait.zero()) {
    read();
    split(paths, at_most);
  }
  if (!paths.empty() || !ended_) return paths;
  // What is left of a name may be another scene's.
  if (!unread_.empty())
    throw InputError(name_ + ":" + std::to_string(lines_ + 1) + ": the line '" + unread_.substr(0, 200) +
                     "' has no newline at its end, so its writer may have been interrupted; end every line with a "
                     "newline, including the last");
  return std::nullopt;
}

bool LineSource::readable(std::chrono::milliseconds wait) const {
  pollfd poll{.fd = file_, .events = POLLIN, .revents = 0};
  return ::poll(&poll, 1, int(wait.count())) > 0;
}

void LineSource::read() {
  std::array<char, 4096> block;
  const ssize_t size = ::read(file_, block.data(), block.size());
  if (size > 0) {
    unread_.append(block.data(), std::size_t(size));
  } else if (size == 0) {
    ended_ = true;
    struct stat status {};
    const bool is_file = ::fstat(file_, &status) == 0 && S_ISREG(status.st_mode);
    if (!unread_.empty() && is_file) unread_ += '\n';  // the last line of a file may come without
  } else if (errno != EAGAIN && errno != EINTR) {
    throw InputError(name_ + ": cannot be read: " + std::strerror(errno));
  }
}

fs::path LineSource::path_of(const std::string& line) const {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  fs::path path = folder_ / line;
  std::error_code ignored;
  if (fs::exists(path, ignored)) return path;
  std::string_view bare = line;
  if (lines_ == 1 && bare.starts_with(byte_order_mark)) bare.remove_prefix(byte_order_mark.size());
  if (bare.ends_with('\r')) bare.remove_suffix(1);
  return folder_ / bare;
}

void LineSource::split(std::vector<fs::path>& paths, std::size_t at_most) {
  std::size_t begin = 0;
  for (std::size_t end; paths.size() < at_most && (end = unread_.find('\n', begin)) != unread_.npos; begin = end + 1) {
    ++lines_;
    if (unread_.substr(begin, end - begin).find('\0') != unread_.npos)
      throw InputError(name_ + ":" + std::to_string(lines_) +
                       ": contains a NUL character, which no path can; give text with one path a line");
    if (end > begin) paths.push_back(path_of(unread_.substr(begin, end - begin)));
  }
  unread_.erase(0, begin);
  if (paths.size() < at_most && unread_.size() > PATH_MAX)
    throw InputError(name_ + ":" + std::to_string(lines_ + 1) +
                     ": the line is longer than a path can be; give text with one path a line");
}

}  // namespace gestalt::app
