// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/base/output_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <deque>
#include <memory>

#include "gestalt/core/base/error.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view temporary_mark = ".tmp";
constexpr const char* choose_another = "; choose another --output";

/// The process whose temporary file this is; 0: it is none. Names are FILE.tmp17, or FILE.tmp17-2 where that is taken.
pid_t writer_of(std::string_view name) {
  const std::size_t mark = name.rfind(temporary_mark);
  if (mark == name.npos) return 0;
  pid_t process = 0;
  unsigned count = 0;
  const char* const end = name.data() + name.size();
  auto [rest, error] = std::from_chars(name.data() + mark + temporary_mark.size(), end, process);
  if (error != std::errc{}) return 0;
  if (rest != end && *rest == '-') rest = std::from_chars(rest + 1, end, count).ptr;
  return rest == end ? process : 0;
}

[[noreturn]] void fail(const fs::path& file, const std::string& why) {
  throw OutputError(file.string() + ": cannot be written: " + why);
}

/// A file or folder that is closed at the end; -1: none.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }

  explicit operator bool() const { return number_ >= 0; }
  operator int() const { return number_; }  // NOLINT(google-explicit-constructor): for the system's functions
  int close() { return number_ < 0 ? 0 : ::close(std::exchange(number_, -1)); }

 private:
  int number_;
};

constexpr int as_folder = O_RDONLY | O_DIRECTORY | O_CLOEXEC;

bool is_link(int folder, const fs::path& name) {
  struct stat status {};
  return ::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISLNK(status.st_mode);
}

/// What the user has named as a folder, and what of the way below it leads to one.
struct Way {
  fs::path named, below;
};

/// The folder of a file, and the file's name in it.
std::pair<Way, fs::path> split(const OutputPath& file) {
  if (file.below().empty()) return {{file.named().parent_path(), {}}, file.named().filename()};
  return {{file.named(), file.below().parent_path()}, file.below().filename()};
}

/// Opens a folder, and makes it and those around it where they are missing. file: for messages.
Descriptor open_folder(const Way& way, const fs::path& file) {
  fs::path path = way.named.empty() ? "." : way.named;
  std::error_code error;
  fs::create_directories(path, error);
  if (error) fail(file, error.message() + choose_another);
  Descriptor folder(::open(path.c_str(), as_folder));
  if (!folder) fail(file, std::strerror(errno) + std::string(choose_another));
  for (const fs::path& name : way.below) {
    path /= name;
    if (name == "..") fail(file, path.string() + " leads out of the output folder");
    if (::mkdirat(folder, name.c_str(), 0777) != 0 && errno != EEXIST)
      fail(file, std::strerror(errno) + std::string(choose_another));
    Descriptor inner(::openat(folder, name.c_str(), as_folder | O_NOFOLLOW));
    const int why = errno;
    if (!inner && is_link(folder, name))
      throw OutputError(path.string() + ": is a link, which may lead out of the output folder; remove it or choose " +
                        "another --output");
    if (!inner) fail(file, std::strerror(why) + std::string(choose_another));
    folder = std::move(inner);
  }
  return folder;
}

/// A written file that still has its temporary name, and is removed if it keeps that.
class StagedFile {
 public:
  StagedFile(const OutputPath& file, std::string_view bytes) : file_(file.path()) {
    auto [way, name] = split(file);
    name_ = std::move(name);
    folder_ = open_folder(way, file_);
    require_replaceable();
    Descriptor out = create();
    if (!out) fail_to_write();
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t written = ::write(out, bytes.data() + done, bytes.size() - done);
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail_to_write();
      done += std::size_t(written);
    }
    if (out.close() != 0) fail_to_write();
  }
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;
  ~StagedFile() { remove(); }

  /// Removes what has the final name.
  void retract() const {
    if (::unlinkat(folder_, name_.c_str(), 0) != 0 && errno != ENOENT)
      fail(file_, std::strerror(errno) + std::string(choose_another));
  }

  void publish() {
    if (::renameat(folder_, temporary_.c_str(), folder_, name_.c_str()) != 0)
      fail(file_, std::strerror(errno) + std::string(choose_another));
    temporary_.clear();
  }

 private:
  /// A device would be replaced by the renamed file, not written.
  void require_replaceable() const {
    struct stat status {};
    if (name_.empty() || name_ == "." || name_ == "..") fail(file_, std::string("it is a folder") + choose_another);
    if (::fstatat(folder_, name_.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) return;
    if (S_ISDIR(status.st_mode)) fail(file_, std::string("it is a folder") + choose_another);
    if (!S_ISREG(status.st_mode) && !S_ISLNK(status.st_mode))
      fail(file_, std::string("it is not a regular file") + choose_another);
  }

  /// A new file: other threads, and processes that have this one's number elsewhere, write under other names.
  Descriptor create() {
    constexpr int most_tries = 1000;
    for (int i = 0; i < most_tries; ++i) {
      temporary_ = name_;
      temporary_ += temporary_mark;
      temporary_ += std::to_string(::getpid()) + (i > 0 ? "-" + std::to_string(i) : "");
      Descriptor out(::openat(folder_, temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
      if (out || errno != EEXIST) return out;
    }
    return Descriptor(-1);
  }

  [[noreturn]] void fail_to_write() {
    const std::string why = std::strerror(errno);
    remove();
    fail(file_, why + "; check permission and free space");
  }

  void remove() const {
    if (!temporary_.empty()) ::unlinkat(folder_, temporary_.c_str(), 0);
  }

  const fs::path file_;
  fs::path name_;
  Descriptor folder_{-1};
  fs::path temporary_;  ///< in the folder; empty once it is published
};

/// The file itself, or the one behind the link that has its name.
fs::path behind_links(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) return file;
  if (fs::is_directory(status)) fail(file, std::string("it is a folder") + choose_another);
  fs::path resolved = fs::canonical(file, error);
  if (error) fail(file, error.message());
  return resolved;
}

}  // namespace

OutputPath OutputPath::operator/(const std::filesystem::path& name) const {
  OutputPath inner = *this;
  inner.below_ /= name;
  return inner;
}

void write_file(const fs::path& file, std::string_view bytes) { StagedFile(behind_links(file), bytes).publish(); }

void write_files(const std::vector<OutputFile>& files) {
  std::deque<StagedFile> staged;
  for (const auto& [file, bytes] : files) staged.emplace_back(file, bytes);
  for (StagedFile& file : staged) file.publish();
}

void write_files(const std::vector<OutputFile>& files, const OutputFile& last) {
  std::deque<StagedFile> staged;
  for (const auto& [file, bytes] : files) staged.emplace_back(file, bytes);
  StagedFile staged_last(last.file, last.bytes);
  staged_last.retract();
  for (StagedFile& file : staged) file.publish();
  staged_last.publish();
}

void remove_abandoned(const OutputPath& place) {
  Descriptor folder(::open(place.named().empty() ? "." : place.named().c_str(), as_folder));
  for (const fs::path& name : place.below())
    if (folder) folder = Descriptor(::openat(folder, name.c_str(), as_folder | O_NOFOLLOW));
  if (!folder) return;
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(::fdopendir(::dup(folder)), ::closedir);
  if (!entries) return;
  while (const dirent* entry = ::readdir(entries.get())) {
    const pid_t writer = writer_of(entry->d_name);
    if (writer > 0 && ::kill(writer, 0) != 0 && errno == ESRCH) ::unlinkat(folder, entry->d_name, 0);
  }
}

}  // namespace gestalt
