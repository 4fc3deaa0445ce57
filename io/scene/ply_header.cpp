// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ply_header.h"

#include <charconv>
#include <map>
#include <optional>
#include <string>
#include <unordered_set>

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

  PlyHeader read() {
    line_.next();
    if (line_[0] != "ply") line_.fail("a PLY file begins with 'ply', not " + shown(line_[0]));
    for (line_.next(); line_[0] != "end_header"; line_.next()) take_line();
    if (!has_format_) line_.fail("the header has no line 'format'");
    if (vertices_.fields.empty())
      line_.fail("the header has no element 'vertex' with properties; a cloud needs x, y and z");
    if (vertices_.points() * vertices_.point_bytes() > most_cloud_bytes)
      line_.fail("the cloud has more than 2^31 bytes; split it");
    vertices_.body = line_.end();
    vertices_.lines = line_.number();
    return std::move(header_);
  }

 private:
  void take_line() {
    if (line_[0] == "format") return take_format();
    if (line_[0] == "element") return take_element();
    if (line_[0] == "property") return take_property();
    line_.fail(shown(line_[0]) + " is not a line of a PLY header; write the cloud again");
  }

  void take_format() {
    const std::string_view format = line_.size() == 3 ? line_[1] : "";
    header_.big_endian = format == "binary_big_endian";
    if (format != "ascii" && format != "binary_little_endian" && !header_.big_endian)
      line_.fail("expected 'format ascii 1.0', 'format binary_little_endian 1.0' or 'format binary_big_endian 1.0'");
    vertices_.data = format == "ascii" ? PcdHeader::Data::ascii : PcdHeader::Data::binary;
    has_format_ = true;
  }

  void take_element() {
    const auto count = line_.size() == 3 ? number(line_[2]) : std::nullopt;
    if (line_.size() != 3) line_.fail("expected 'element NAME COUNT'");
    in_vertex_ = line_[1] == "vertex";
    if (!in_vertex_ && vertices_.width > 0) return;
    if (!count || *count > std::size_t{most_pixels} || (in_vertex_ && *count == 0))
      line_.fail(in_vertex_ ? "the number of vertices must be from 1 to 2^26"
                            : "the number of an element before the vertices must be from 0 to 2^26");
    if (!in_vertex_) {
      header_.before.push_back({*count, {}});
      return;
    }
    if (vertices_.width) line_.fail("duplicate element 'vertex'");
    vertices_.width = int(*count);
    vertices_.height = 1;
  }

  void take_property() {
    if (in_vertex_) return take_vertex_property();
    if (vertices_.width > 0) return;  // of what follows the vertices
    if (header_.before.empty()) line_.fail("there is a property before the first element; write the cloud again");
    const bool list = line_.size() == 5 && line_[1] == "list";
    const auto scalar = scalars.find(list ? line_[3] : line_.size() == 3 ? line_[1] : "");
    const auto length = list ? scalars.find(line_[2]) : scalar;
    if (scalar == scalars.end() || length == scalars.end() || (list && length->second.type == 'F'))
      line_.fail("expected 'property TYPE NAME' or 'property list TYPE TYPE NAME' with types such as float or uchar");
    PlyHeader::Property property{scalar->second.size};
    if (list) property.length_size = length->second.size, property.length_type = length->second.type;
    header_.before.back().properties.push_back(property);
  }

  void take_vertex_property() {
    const auto scalar = line_.size() == 3 ? scalars.find(line_[1]) : scalars.end();
    if (scalar == scalars.end())
      line_.fail(
          "a property of a vertex must be 'property TYPE NAME' with a type such as float or uchar; write vertices "
          "without "
          "lists");
    if (!names_.emplace(line_[2]).second) line_.fail("property " + shown(line_[2]) + " appears twice");
    const std::size_t offset = vertices_.fields.empty() ? 0 : vertices_.point_bytes();
    vertices_.fields.push_back({std::string(line_[2]), scalar->second.type, scalar->second.size, 1, offset});
  }

  static std::optional<std::size_t> number(std::string_view word) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return value;
  }

  HeaderLine line_;
  PlyHeader header_;
  PcdHeader& vertices_ = header_.vertices;
  std::unordered_set<std::string_view> names_;  ///< of the vertices' properties
  bool has_format_ = false, in_vertex_ = false;
};

}  // namespace

PlyHeader parse_ply_header(const fs::path& file, std::string_view bytes) { return PlyHeaderReader(file, bytes).read(); }

}  // namespace gestalt
