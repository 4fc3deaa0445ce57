// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ply_header.h"

#include <charconv>
#include <map>
#include <optional>
#include <string>

#include "header_line.h"
#include "most_pixels.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

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

class PlyHeaderReader {
 public:
  PlyHeaderReader(const fs::path& file, std::string_view bytes)
      : line_(file, bytes, "PLY", [](std::string_view word) { return word == "comment" || word == "obj_info"; }) {}

  PcdHeader read() {
    line_.next();
    if (line_[0] != "ply") line_.fail("a PLY file begins with 'ply', not " + shown(line_[0]));
    for (line_.next(); line_[0] != "end_header"; line_.next()) take_line();
    if (!has_format_) line_.fail("the header has no line 'format'");
    if (header_.fields.empty())
      line_.fail("the header has no element 'vertex' with properties; a cloud needs x, y and z");
    if (header_.points() * header_.point_bytes() > most_cloud_bytes)
      line_.fail("the cloud has more than 2^31 bytes; divide it");
    header_.body = line_.end();
    header_.lines = line_.number();
    return std::move(header_);
  }

 private:
  void take_line() {
    if (line_[0] == "format") return take_format();
    if (line_[0] == "element") return take_element();
    if (line_[0] == "property") return take_property();
    line_.fail(shown(line_[0]) + " is no line of a PLY header; write the cloud again");
  }

  void take_format() {
    const std::string_view format = line_.size() == 3 ? line_[1] : "";
    if (format != "ascii" && format != "binary_little_endian")
      line_.fail("expected 'format ascii 1.0' or 'format binary_little_endian 1.0'; write the cloud as one of these");
    header_.data = format == "ascii" ? PcdHeader::Data::ascii : PcdHeader::Data::binary;
    has_format_ = true;
  }

  void take_element() {
    if (line_.size() != 3) line_.fail("expected 'element NAME COUNT'");
    in_vertex_ = line_[1] == "vertex";
    if (!in_vertex_ && header_.width == 0)
      line_.fail("element " + shown(line_[1]) + " stands before 'vertex'; write the vertices first");
    if (!in_vertex_) return;
    std::size_t count = 0;
    const auto [end, error] = std::from_chars(line_[2].data(), line_[2].data() + line_[2].size(), count);
    if (error != std::errc{} || end != line_[2].data() + line_[2].size() || count == 0 ||
        count > std::size_t{most_pixels})
      line_.fail("the number of vertices must be from 1 to 2^26");
    if (header_.width) line_.fail("'vertex' stands here a second time");
    header_.width = int(count);
    header_.height = 1;
  }

  void take_property() {
    if (!in_vertex_) return;
    const auto scalar = line_.size() == 3 ? scalars.find(line_[1]) : scalars.end();
    if (scalar == scalars.end())
      line_.fail(
          "a property of a vertex must be 'property TYPE NAME' with a type as float or uchar; write vertices without "
          "lists");
    const std::string name(line_[2]);
    if (header_.find(name)) line_.fail("property " + shown(name) + " stands here a second time");
    const std::size_t offset = header_.fields.empty() ? 0 : header_.point_bytes();
    header_.fields.push_back({name, scalar->second.type, scalar->second.size, 1, offset});
  }

  HeaderLine line_;
  PcdHeader header_;
  bool has_format_ = false, in_vertex_ = false;
};

}  // namespace

PcdHeader parse_ply_header(const fs::path& file, std::string_view bytes) { return PlyHeaderReader(file, bytes).read(); }

}  // namespace gestalt
