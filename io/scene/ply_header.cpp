// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ply_header.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string>

#include "gestalt/core/base/error.h"
#include "words.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_points = std::size_t{1} << 26;
constexpr std::size_t most_bytes = std::size_t{1} << 31;

struct Scalar {
  char type;
  int size;
};

/// Both generations of names.
const std::map<std::string_view, Scalar> scalars{
    {"char", {'I', 1}},  {"uchar", {'U', 1}},  {"short", {'I', 2}},   {"ushort", {'U', 2}},
    {"int", {'I', 4}},   {"uint", {'U', 4}},   {"float", {'F', 4}},   {"double", {'F', 8}},
    {"int8", {'I', 1}},  {"uint8", {'U', 1}},  {"int16", {'I', 2}},   {"uint16", {'U', 2}},
    {"int32", {'I', 4}}, {"uint32", {'U', 4}}, {"float32", {'F', 4}}, {"float64", {'F', 8}}};

/// A word in quotes, as far as it can be shown.
std::string shown(std::string_view word) {
  std::string text(word.substr(0, 40));
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 32 || c > 126; }, '?');
  return "'" + text + "'";
}

class HeaderReader {
 public:
  HeaderReader(const fs::path& file, std::string_view bytes) : file_(file), bytes_(bytes) {}

  PcdHeader read() {
    next();
    if (words_[0] != "ply") fail("a PLY file begins with 'ply', not " + shown(words_[0]));
    for (next(); words_[0] != "end_header"; next()) take_line();
    if (!has_format_) fail("the header has no line 'format'");
    if (header_.fields.empty()) fail("the header has no element 'vertex' with properties; a cloud needs x, y and z");
    if (header_.points() * header_.point_bytes() > most_bytes) fail("the cloud has more than 2^31 bytes; divide it");
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(file_.string() + ":" + std::to_string(header_.lines) + ": " + what);
  }

  /// Takes the next line that is not empty or a comment.
  void next() {
    do {
      const std::size_t end = bytes_.find('\n', header_.body);
      // A line of a header is short: a long one is data.
      if (end == bytes_.npos || end - header_.body > 4096)
        fail("the PLY header breaks off here; the file is truncated or no point cloud, write it again");
      words_ = words_of(bytes_.substr(header_.body, end - header_.body));
      header_.body = end + 1;
      ++header_.lines;
    } while (words_.empty() || words_[0] == "comment" || words_[0] == "obj_info");
  }

  void take_line() {
    if (words_[0] == "format") return take_format();
    if (words_[0] == "element") return take_element();
    if (words_[0] == "property") return take_property();
    fail(shown(words_[0]) + " is no line of a PLY header; write the cloud again");
  }

  void take_format() {
    const std::string_view format = words_.size() == 3 ? words_[1] : "";
    if (format != "ascii" && format != "binary_little_endian")
      fail("expected 'format ascii 1.0' or 'format binary_little_endian 1.0'; write the cloud as one of these");
    header_.data = format == "ascii" ? PcdHeader::Data::ascii : PcdHeader::Data::binary;
    has_format_ = true;
  }

  void take_element() {
    if (words_.size() != 3) fail("expected 'element NAME COUNT'");
    in_vertex_ = words_[1] == "vertex";
    if (!in_vertex_ && header_.width == 0)
      fail("element " + shown(words_[1]) + " stands before 'vertex'; write the vertices first");
    if (!in_vertex_) return;
    std::size_t count = 0;
    const auto [end, error] = std::from_chars(words_[2].data(), words_[2].data() + words_[2].size(), count);
    if (error != std::errc{} || end != words_[2].data() + words_[2].size() || count == 0 || count > most_points)
      fail("the number of vertices must be from 1 to 2^26");
    if (header_.width) fail("'vertex' stands here a second time");
    header_.width = int(count);
    header_.height = 1;
  }

  void take_property() {
    if (!in_vertex_) return;
    const auto scalar = words_.size() == 3 ? scalars.find(words_[1]) : scalars.end();
    if (scalar == scalars.end())
      fail(
          "a property of a vertex must be 'property TYPE NAME' with a type as float or uchar; write vertices without "
          "lists");
    const std::string name(words_[2]);
    if (header_.find(name)) fail("property " + shown(name) + " stands here a second time");
    const std::size_t offset = header_.fields.empty() ? 0 : header_.point_bytes();
    header_.fields.push_back({name, scalar->second.type, scalar->second.size, 1, offset});
  }

  const fs::path& file_;
  std::string_view bytes_;
  PcdHeader header_;
  std::vector<std::string_view> words_;
  bool has_format_ = false, in_vertex_ = false;
};

}  // namespace

PcdHeader parse_ply_header(const fs::path& file, std::string_view bytes) { return HeaderReader(file, bytes).read(); }

}  // namespace gestalt
