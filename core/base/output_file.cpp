// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/base/output_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <deque>
#include <map>
#include <memory>

#include "folder_lock.h"
#include "gestalt/core/base/error.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

constexpr const char* choose_another = "; choose another --output";

// Of names that nobody else gives to files: .gestalt-0123456789abcdef.tmp
constexpr std::string_view temporary_begin = ".gestalt-", temporary_end = ".tmp", hex_digits = "0123456789abcdef";
constexpr std::size_t temporary_digits = 16;

std::string temporary_name() {
  std::array<unsigned char, temporary_digits / 2> random{};
  if (::getentropy(random.data(), random.size()) != 0) throw OutputError("the system provides no random numbers");
  std::string name(temporary_begin);
  for (const unsigned char byte : random) {
    name += hex_digits[byte >> 4];
    name += hex_digits[byte & 15];
  }
  return name.append(temporary_end);
}

bool is_temporary(std::string_view name) {
  if (name.size() != temporary_begin.size() + temporary_digits + temporary_end.size()) return false;
  const std::string_view digits = name.substr(temporary_begin.size(), temporary_digits);
  return name.starts_with(temporary_begin) && name.ends_with(temporary_end) &&
         digits.find_first_not_of(hex_digits) == digits.npos;
}

[[noreturn]] void fail(const fs::path& file, const std::string& why) {
  throw OutputError(file.string() + ": cannot be written: " + why);
}

constexpr int as_folder = O_RDONLY | O_DIRECTORY | O_CLOEXEC;

bool is_link(int folder, const fs::path& name) {
  struct stat status {};
  return ::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISLNK(status.st_mode);
}

/// Whether a part of a way below a folder, as data may have named it, is none of a folder there.
bool leads_out(const fs::path& name) { return name == ".." || name.is_absolute(); }

bool has_nul(const fs::path& name) { return name.native().find('\0') != fs::path::string_type::npos; }

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
    if (leads_out(name)) fail(file, path.string() + " leads outside the output folder");
    if (has_nul(name)) fail(file.parent_path().c_str(), "its name has a NUL character, which no file's can; rename it");
    if (::mkdirat(folder, name.c_str(), 0777) != 0 && errno != EEXIST)
      fail(file, std::strerror(errno) + std::string(choose_another));
    Descriptor inner(::openat(folder, name.c_str(), as_folder | O_NOFOLLOW));
    const int why = errno;
    if (!inner && is_link(folder, name))
      throw OutputError(path.string() +
                        ": is a symbolic link that may lead outside the output folder; remove it or choose " +
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
    out_ = create();
    if (!out_) fail_to_write();
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t written = ::write(out_, bytes.data() + done, bytes.size() - done);
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail_to_write();
      done += std::size_t(written);
    }
    // Some file systems tell only now that it could not be written; what stays open keeps the file's lock.
    if (Descriptor(::dup(out_)).close() != 0) fail_to_write();
  }
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;
  ~StagedFile() { remove(); }

  /// Removes what has the final name.
  void retract() const { retract(name_); }

  /// The same for another file beside it.
  void retract(const fs::path& name) const {
    if (::unlinkat(folder_, name.c_str(), 0) != 0 && errno != ENOENT)
      fail(file_.parent_path() / name, std::strerror(errno) + std::string(choose_another));
  }

  FolderLock lock_folder() const { return {folder_, file_.parent_path()}; }

  /// Device and number.
  std::pair<dev_t, ino_t> folder() const {
    struct stat status {};
    if (::fstat(folder_, &status) != 0) fail(file_, std::strerror(errno));
    return {status.st_dev, status.st_ino};
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

  /// A new file with a lock, without which it would count as abandoned where it has been taken away before that.
  Descriptor create() {
    for (;;) {
      temporary_ = temporary_name();
      Descriptor out(::openat(folder_, temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
      if (!out && errno == EEXIST) continue;
      if (!out) return out;
      if (!try_lock(out)) {
        if (errno == EWOULDBLOCK) continue;  // remove_abandoned() has it and takes it away
        return out;                          // there are no locks here
      }
      struct stat status {};
      if (::fstat(out, &status) == 0 && status.st_nlink > 0) return out;
    }
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
  Descriptor folder_{-1}, out_{-1};
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

namespace {

using Names = std::function<std::vector<std::string>()>;

/// Gives files their names; last, when it is there, tells that all of the others have theirs, and has others beside it
/// that are outdated.
void publish_together(std::deque<StagedFile>& staged, StagedFile* last, const Names& outdated) {
  // In one order, so that no two writers wait for each other.
  std::map<std::pair<dev_t, ino_t>, const StagedFile*> folders;
  for (const StagedFile& file : staged) folders.emplace(file.folder(), &file);
  if (last) folders.emplace(last->folder(), last);
  std::deque<FolderLock> locks;
  for (const auto& [folder, file] : folders) locks.push_back(file->lock_folder());
  const std::vector<std::string> old = outdated ? outdated() : std::vector<std::string>();
  if (last) last->retract();
  for (const std::string& name : old) last->retract(name);
  for (StagedFile& file : staged) file.publish();
  if (last) last->publish();
}

}  // namespace

void write_file(const fs::path& file, std::string_view bytes) { StagedFile(behind_links(file), bytes).publish(); }

void write_files(const std::vector<OutputFile>& files) {
  std::deque<StagedFile> staged;
  for (const auto& [file, bytes] : files) staged.emplace_back(file, bytes);
  if (staged.size() == 1) return staged.front().publish();
  publish_together(staged, nullptr, {});
}

void write_files(const std::vector<OutputFile>& files, const OutputFile& last, const Names& outdated) {
  std::deque<StagedFile> staged;
  for (const auto& [file, bytes] : files) staged.emplace_back(file, bytes);
  StagedFile staged_last(last.file, last.bytes);
  publish_together(staged, &staged_last, outdated);
}

void update_file(const OutputPath& file, const std::function<std::string()>& content) {
  const Descriptor folder = open_folder(split(file).first, file.path());
  const FolderLock lock(folder, file.path().parent_path());
  StagedFile(file, content()).publish();
}

void remove_abandoned(const OutputPath& place) {
  Descriptor folder(::open(place.named().empty() ? "." : place.named().c_str(), as_folder));
  for (const fs::path& name : place.below())
    if (folder) folder = Descriptor(leads_out(name) ? -1 : ::openat(folder, name.c_str(), as_folder | O_NOFOLLOW));
  if (!folder) return;
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(::fdopendir(::dup(folder)), ::closedir);
  if (!entries) return;
  while (const dirent* entry = ::readdir(entries.get())) {
    if (!is_temporary(entry->d_name)) continue;
    const Descriptor file(::openat(folder, entry->d_name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (file && try_lock(file)) ::unlinkat(folder, entry->d_name, 0);
  }
}

}  // namespace gestalt
