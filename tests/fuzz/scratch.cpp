// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scratch.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>

namespace gestalt::fuzz {

namespace fs = std::filesystem;

Scratch::Scratch() {
  std::error_code ignored;
  const fs::path memory = "/dev/shm";
  std::string name =
      ((fs::is_directory(memory, ignored) ? memory : fs::temp_directory_path()) / "gestalt_fuzz_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) std::abort();
  folder_ = name;
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

fs::path Scratch::write(const std::string& name, std::string_view bytes) const {
  fs::path file = folder_ / name;
  std::ofstream out(file, std::ios::binary);
  if (!out) {
    fs::create_directories(file.parent_path());
    out.open(file, std::ios::binary);
  }
  out.write(bytes.data(), std::streamsize(bytes.size()));
  if (!out.flush()) std::abort();
  return file;
}

std::vector<std::string_view> parts_of(std::string_view input, std::size_t count) {
  std::vector<std::string_view> parts;
  while (parts.size() + 1 < count) {
    const std::size_t end = std::min(input.find('\xff'), input.size());
    parts.push_back(input.substr(0, end));
    input.remove_prefix(std::min(end + 1, input.size()));
  }
  parts.push_back(input);
  return parts;
}

}  // namespace gestalt::fuzz
