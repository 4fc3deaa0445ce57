// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/pcd_header.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>

#include "gestalt/core/base/file_bytes.h"
#include "header_line.h"
#include "most_pixels.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

/// Reads a header line by line in the order that the format prescribes.
class PcdHeaderReader {
 public:
  PcdHeaderReader(const fs::path& file, std::string_view bytes)
      : line_(file, bytes, "PCD", [](std::string_view word) { return word.starts_with('#'); }) {}

  PcdHeader read() {
    line_.next();
    if (is("VERSION")) version();
    expect(is("FIELDS") || is("COLUMNS"), "FIELDS");
    names();
    expect(is("SIZE") || old_, "SIZE");
    if (is("SIZE")) sizes();
    expect(is("TYPE") || old_, "TYPE");
    if (is("TYPE")) types();
    if (is("COUNT")) counts();
    lay_out();
    expect(is("WIDTH") || old_, "WIDTH");
    if (is("WIDTH")) {
      header_.width = int(extent());
      expect(is("HEIGHT"), "HEIGHT");
      header_.height = int(extent());
    }
    if (is("VIEWPOINT")) viewpoint();
    expect(is("POINTS"), "POINTS");
    points();
    expect(is("DATA"), "DATA");
    data();
    header_.body = line_.end();
    header_.lines = line_.number();
    return std::move(header_);
  }

 private:
  bool is(std::string_view key) const { return line_[0] == key; }

  void expect(bool found, const std::string& key) const {
    if (!found) line_.fail("a PCD header has " + key + " here, not " + shown(line_[0]) + "; correct the header");
  }

  std::optional<std::uint64_t> number(std::string_view word) const {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return value;
  }

  void version() {
    const std::set<std::string_view> known{"0.5", ".5", "0.6", ".6", "0.7", ".7"};
    if (line_.size() != 2 || !known.count(line_[1]))
      line_.fail("only PCD versions 0.5, 0.6 and 0.7 can be read; convert the file with PCL");
    old_ = line_[1].ends_with(".5");
    line_.next();
  }

  void names() {
    std::set<std::string_view> seen;
    for (std::size_t i = 1; i < line_.size(); ++i) {
      if (line_[i] != "_" && !seen.insert(line_[i]).second)
        line_.fail("field " + shown(line_[i]) + " appears twice; correct the header");
      header_.fields.push_back({std::string(line_[i]), 'F', 4, 1, 0});
    }
    if (header_.fields.empty()) line_.fail("FIELDS names no field; correct the header");
    line_.next();
  }

  void expect_one_for_each_field() const {
    if (line_.size() != header_.fields.size() + 1)
      line_.fail(std::string(line_[0]) + " has " + std::to_string(line_.size() - 1) + " entries for " +
                 std::to_string(header_.fields.size()) + " fields; correct the header");
  }

  void sizes() {
    expect_one_for_each_field();
    for (std::size_t i = 1; i < line_.size(); ++i) {
      const auto size = number(line_[i]);
      if (size != 1u && size != 2u && size != 4u && size != 8u)
        line_.fail("size " + shown(line_[i]) + " of field " + shown(header_.fields[i - 1].name) +
                   " must be 1, 2, 4 or 8 bytes");
      header_.fields[i - 1].size = int(*size);
    }
    line_.next();
  }

  void types() {
    expect_one_for_each_field();
    for (std::size_t i = 1; i < line_.size(); ++i) {
      PcdHeader::Field& field = header_.fields[i - 1];
      const bool known = line_[i] == "I" || line_[i] == "U" || (line_[i] == "F" && field.size >= 4);
      if (!known)
        line_.fail("type " + shown(line_[i]) + " of field " + shown(field.name) + " with " +
                   std::to_string(field.size) + " bytes must be I, U, or F with 4 or 8 bytes");
      field.type = line_[i][0];
    }
    line_.next();
  }

  void counts() {
    constexpr std::uint64_t most = 1 << 16;
    expect_one_for_each_field();
    for (std::size_t i = 1; i < line_.size(); ++i) {
      const auto count = number(line_[i]);
      if (!count || *count > most)
        line_.fail("count " + shown(line_[i]) + " of field " + shown(header_.fields[i - 1].name) +
                   " must be from 0 to 65536");
      header_.fields[i - 1].count = *count;
    }
    // Such a field takes no bytes; drivers write padding so.
    std::erase_if(header_.fields, [](const PcdHeader::Field& field) { return field.count == 0; });
    if (header_.fields.empty()) line_.fail("every field has the count 0; correct the header");
    line_.next();
  }

  void lay_out() {
    std::size_t offset = 0;
    for (PcdHeader::Field& field : header_.fields) {
      field.offset = offset;
      offset += field.bytes();
    }
  }

  std::uint64_t extent() {
    const std::uint64_t value = extent_here();
    line_.next();
    return value;
  }

  std::uint64_t extent_here() const {
    const auto value = line_.size() == 2 ? number(line_[1]) : std::nullopt;
    if (!value || *value < 1 || *value > std::uint64_t{most_pixels})
      line_.fail(std::string(line_[0]) + " must be one whole number from 1 to 2^26; correct the header");
    return *value;
  }

  /// One that is not a position and a rotation is left out, as PCL does.
  void viewpoint() {
    std::array<double, 7> values{};
    bool sound = line_.size() == values.size() + 1;
    for (std::size_t i = 0; sound && i < values.size(); ++i) {
      const std::string_view word = line_[i + 1];
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), values[i]);
      sound = error == std::errc{} && end == word.data() + word.size() && std::isfinite(values[i]);
    }
    if (sound) header_.viewpoint = values;
    line_.next();
  }

  void points() {
    if (header_.width == 0) {  // version 0.5: one row of all points
      header_.width = int(extent_here());
      header_.height = 1;
    }
    const std::uint64_t product = std::uint64_t(header_.width) * std::uint64_t(header_.height);
    const auto value = line_.size() == 2 ? number(line_[1]) : std::nullopt;
    if (value != product)
      line_.fail("POINTS must be WIDTH x HEIGHT = " + std::to_string(product) + "; correct the header");
    if (product > std::uint64_t{most_pixels} || product * header_.point_bytes() > most_cloud_bytes)
      line_.fail("declares " + std::to_string(product) + " points of " + std::to_string(header_.point_bytes()) +
                 " bytes; clouds of up to 2^26 points and 2^31 bytes can be read");
    line_.next();
  }

  void data() {
    using Data = PcdHeader::Data;
    for (const Data kind : {Data::ascii, Data::binary, Data::binary_compressed})
      if (line_.size() == 2 && line_[1] == to_string(kind)) {
        header_.data = kind;
        return;
      }
    line_.fail("DATA must be ascii, binary or binary_compressed; correct the header");
  }

  HeaderLine line_;
  PcdHeader header_;
  bool old_ = false;  ///< version 0.5, in which sizes, types and the grid may be missing
};

}  // namespace

const PcdHeader::Field* PcdHeader::find(std::string_view name) const {
  const auto field = std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
  return field == fields.end() ? nullptr : &*field;
}

const char* to_string(PcdHeader::Data data) {
  return data == PcdHeader::Data::ascii ? "ascii" : data == PcdHeader::Data::binary ? "binary" : "binary_compressed";
}

PcdHeader parse_pcd_header(const fs::path& file, std::string_view bytes) { return PcdHeaderReader(file, bytes).read(); }

PcdHeader read_pcd_header(const fs::path& file) { return parse_pcd_header(file, read_bytes(file, largest_cloud_file)); }

}  // namespace gestalt
