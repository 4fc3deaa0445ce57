// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gestalt {

/// A line of the text that a cloud's file begins with, as its words; goes from line to line.
class HeaderLine {
 public:
  /// Before the first line. file and format are for messages; what comment() says of a line's first word leaves the
  /// line out, as empty ones are. file and bytes must outlive this.
  HeaderLine(const std::filesystem::path& file, std::string_view bytes, std::string format,
             bool (*comment)(std::string_view))
      : file_(file), bytes_(bytes), format_(std::move(format)), comment_(comment) {}

  /// Takes the next line. Throws InputError where there is none.
  void next();

  std::string_view operator[](std::size_t i) const { return words_[i]; }
  std::size_t size() const { return words_.size(); }

  /// Offset of the first byte after the line.
  std::size_t end() const { return end_; }
  /// Counted from 1.
  int number() const { return number_; }

  /// Throws InputError naming the file and the line.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  const std::filesystem::path& file_;
  std::string_view bytes_;
  std::string format_;
  bool (*comment_)(std::string_view);
  std::vector<std::string_view> words_;
  std::size_t end_ = 0;
  int number_ = 0;
};

/// A word of a file in quotes, as far as a message can show it.
std::string shown(std::string_view word);

}  // namespace gestalt
