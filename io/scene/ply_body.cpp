// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ply_body.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "ascii_value.h"
#include "gestalt/core/base/error.h"
#include "header_line.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void reject_truncated(const fs::path& file, const std::string& what) {
  throw InputError(file.string() + ": ends within " + what + "; the file is truncated, write it again");
}

std::string vertex(std::size_t i, const PcdHeader& vertices) {
  return "vertex " + std::to_string(i) + " of " + std::to_string(vertices.points());
}

/// The words of the body, whatever lines they stand in.
class Words {
 public:
  Words(std::string_view body, int lines_before) : body_(body), line_(lines_before + 1) {}

  /// Empty at the end.
  std::string_view next() {
    constexpr std::string_view blank = " \t\r\n";
    const std::size_t begin = std::min(body_.find_first_not_of(blank, at_), body_.size());
    line_ += int(std::count(body_.begin() + std::ptrdiff_t(at_), body_.begin() + std::ptrdiff_t(begin), '\n'));
    at_ = std::min(body_.find_first_of(blank, begin), body_.size());
    return body_.substr(begin, at_ - begin);
  }

  int line() const { return line_; }

 private:
  std::string_view body_;
  std::size_t at_ = 0;
  int line_;
};

std::string read_ascii_vertices(const fs::path& file, const PlyHeader& header, std::string_view body) {
  Words words(body, header.vertices.lines);
  const auto wrong = [&](std::string_view word, const std::string& what) {
    throw InputError(file.string() + ":" + std::to_string(words.line()) + ": " + shown(word) + " is not a valid " +
                     what + "; write the cloud again");
  };
  for (const PlyHeader::Element& element : header.before)
    for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i)
      for (const PlyHeader::Property& property : element.properties) {
        std::string_view word = words.next();
        std::size_t more = 0;
        if (property.length_size > 0) {
          const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), more);
          if (!word.empty() && (error != std::errc{} || end != word.data() + word.size()))
            wrong(word, "length of a list");
        }
        while (more-- > 0 && !word.empty()) word = words.next();
        if (word.empty()) reject_truncated(file, "the elements before the vertices");
      }
  std::string points;
  for (std::size_t i = 0; i < header.vertices.points(); ++i)
    for (const PcdHeader::Field& field : header.vertices.fields) {
      const std::string_view word = words.next();
      if (word.empty()) reject_truncated(file, vertex(i, header.vertices));
      if (!append_value(word, field, points))
        wrong(word, "value of property " + shown(field.name) + " (" + field.type + std::to_string(field.size) + ")");
    }
  return points;
}

/// A whole number of 1, 2, 4 or 8 bytes.
std::uint64_t whole_number(std::string_view bytes, bool big_endian) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    value = value << 8 | std::uint8_t(bytes[big_endian ? i : bytes.size() - 1 - i]);
  return value;
}

/// How many bytes stand before the vertices.
std::size_t bytes_before(const fs::path& file, const PlyHeader& header, std::string_view body) {
  std::size_t at = 0;
  const auto skip = [&](std::size_t count, int size) {
    if (count > (body.size() - at) / std::size_t(size)) reject_truncated(file, "the elements before the vertices");
    at += count * std::size_t(size);
  };
  for (const PlyHeader::Element& element : header.before)
    for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i)
      for (const PlyHeader::Property& property : element.properties) {
        std::size_t count = 1;
        if (property.length_size > 0) {
          const std::size_t from = at;
          skip(1, property.length_size);
          count = whole_number(body.substr(from, at - from), header.big_endian);
        }
        skip(count, property.size);
      }
  return at;
}

std::string read_binary_vertices(const fs::path& file, const PlyHeader& header, std::string_view body) {
  const PcdHeader& vertices = header.vertices;
  const std::string_view after = body.substr(bytes_before(file, header, body));
  const std::size_t step = vertices.point_bytes();
  if (after.size() / step < vertices.points()) reject_truncated(file, vertex(after.size() / step, vertices));
  std::string points(after.substr(0, vertices.points() * step));
  if (header.big_endian)
    for (const PcdHeader::Field& field : vertices.fields)
      for (std::size_t at = field.offset; at < points.size(); at += step)
        std::reverse(&points[at], &points[at] + field.size);
  return points;
}

}  // namespace

std::string read_ply_body(const fs::path& file, const PlyHeader& header, std::string_view bytes) {
  const std::string_view body = bytes.substr(header.vertices.body);
  return header.vertices.data == PcdHeader::Data::ascii ? read_ascii_vertices(file, header, body)
                                                        : read_binary_vertices(file, header, body);
}

}  // namespace gestalt
