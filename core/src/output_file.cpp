// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <deque>
#include <fstream>

#include "gestalt/error.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

/// A written file that still has its temporary name, and is removed if it keeps that.
class StagedFile {
 public:
  StagedFile(const fs::path& file, std::string_view bytes) : file_(file), target_(target()), temporary_(target_) {
    temporary_ += ".tmp" + std::to_string(::getpid());
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

  /// The file behind the name, in a folder that exists. A device would be replaced by the renamed file, not written.
  fs::path target() const {
    std::error_code error;
    if (file_.has_parent_path()) fs::create_directories(file_.parent_path(), error);
    if (error) fail(error.message() + "; choose another --output");
    const fs::file_status status = fs::status(file_, error);
    if (!fs::exists(status)) return file_;
    if (fs::is_directory(status)) fail("it is a folder; choose another --output");
    if (!fs::is_regular_file(status)) fail("it is no regular file; choose another --output");
    const fs::path resolved = fs::canonical(file_, error);
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

void write_file(const fs::path& file, std::string_view bytes) { StagedFile(file, bytes).publish(); }

void write_files(const std::vector<OutputFile>& files) {
  std::deque<StagedFile> staged;
  for (const auto& [file, bytes] : files) staged.emplace_back(file, bytes);
  for (StagedFile& file : staged) file.publish();
}

void write_png(const fs::path& file, const cv::Mat& image) { write_file(file, encode_png(image)); }

}  // namespace gestalt
