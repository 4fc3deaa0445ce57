// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "gestalt/error.h"

namespace gestalt {

namespace fs = std::filesystem;

void write_file(const fs::path& file, std::string_view bytes) {
  const auto fail = [&](const std::string& why) { throw OutputError(file.string() + ": cannot be written: " + why); };
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) fail(error.message() + "; choose another --output");

  fs::path temporary = file;
  temporary += ".tmp" + std::to_string(::getpid());
  errno = 0;
  std::ofstream out(temporary, std::ios::binary);
  out.write(bytes.data(), std::streamsize(bytes.size()));
  out.close();
  if (!out) {
    const std::string why = errno ? std::strerror(errno) : "the file system refused it";
    fs::remove(temporary, error);
    fail(why + "; check permission and free space");
  }
  fs::rename(temporary, file, error);
  if (error) {
    const std::string why = error.message();
    fs::remove(temporary, error);
    fail(why);
  }
}

void write_png(const fs::path& file, const cv::Mat& image) {
  std::vector<unsigned char> bytes;
  // Filtered and lightly compressed: a label image costs a tenth of the default's time for a few more bytes.
  if (!cv::imencode(".png", image, bytes, {cv::IMWRITE_PNG_COMPRESSION, 1}))
    throw OutputError(file.string() + ": the image cannot be encoded as PNG");
  write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace gestalt
