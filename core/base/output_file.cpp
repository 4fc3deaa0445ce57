// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/base/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <deque>
#include <fstream>

#include "gestalt/core/base/error.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view temporary_mark = ".tmp";

/// The process whose temporary file this is; 0: it is none.
pid_t writer_of(const std::string& name) {
  const std::size_t mark = name.rfind(temporary_mark);
  if (mark == std::string::npos) return 0;
  pid_t process = 0;
  const char* const end = name.data() + name.size();
  const auto [rest, error] = std::from_chars(name.data() + mark + temporary_mark.size(), end, process);
  return error == std::errc{} && rest == end ? process : 0;
}

/// A written file that still has its temporary name, and is removed if it keeps that.
class StagedFile {
 public:
  /// What becomes of a symbolic link that has the file's name.
  enum class Link { followed, replaced };

  StagedFile(const fs::path& file, std::string_view bytes, Link link = Link::replaced)
      : file_(file), target_(target(link)), temporary_(target_) {
    temporary_ += temporary_mark;
    temporary_ += std::to_string(::getpid());
    std::error_code ignored;
    fs::remove(temporary_, ignored);  // else a link of that name would be followed
    errno = 0;
    std::ofstream out(temporary_, std::ios::binary);
    out.write(bytes.data(), std::streamsize(bytes.size()));
    out.close();
    if (out) return;
    const std::string why = errno ? std::strerror(errno) : "the file system refused it";
    remove();
    fail(why + "; check permission and free space");
  }
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;
  ~StagedFile() { remove(); }

  /// Removes what has the final name.
  void retract() const {
    std::error_code error;
    fs::remove(target_, error);
    if (error) fail(error.message() + "; choose another --output");
  }

  void publish() {
    std::error_code error;
    fs::rename(temporary_, target_, error);
    if (error) fail(error.message() + "; choose another --output");
    temporary_.clear();
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw OutputError(file_.string() + ": cannot be written: " + why);
  }

  /// The file, or the one behind the link, in a folder that exists. A device would be replaced by the renamed file, not
  /// written.
  fs::path target(Link link) const {
    std::error_code error;
    if (file_.has_parent_path()) fs::create_directories(file_.parent_path(), error);
    if (error) fail(error.message() + "; choose another --output");
    const bool is_replaced = link == Link::replaced && fs::is_symlink(fs::symlink_status(file_, error));
    if (is_replaced) return file_;
    const fs::file_status status = fs::status(file_, error);
    if (!fs::exists(status)) return file_;
    if (fs::is_directory(status)) fail("it is a folder; choose another --output");
    if (!fs::is_regular_file(status)) fail("it is no regular file; choose another --output");
    fs::path resolved = fs::canonical(file_, error);
    if (error) fail(error.message());
    return resolved;
  }

  void remove() const {
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
  }

  const fs::path file_;
  const fs::path target_;
  fs::path temporary_;  ///< empty once it is published
};

}  // namespace

void write_file(const fs::path& file, std::string_view bytes) {
  StagedFile(file, bytes, StagedFile::Link::followed).publish();
}

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

void refuse_link(const fs::path& folder) {
  std::error_code error;
  if (fs::is_symlink(fs::symlink_status(folder, error)))
    throw OutputError(folder.string() +
                      ": is a link, which may lead out of the output folder; remove it or choose "
                      "another --output");
}

void remove_abandoned(const fs::path& folder) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const pid_t writer = writer_of(entry->path().filename().string());
    std::error_code ignored;
    if (writer > 0 && ::kill(writer, 0) != 0 && errno == ESRCH) fs::remove(entry->path(), ignored);
  }
}

}  // namespace gestalt
