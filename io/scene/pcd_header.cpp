// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/pcd_header.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <set>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"
#include "words.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

/// Reads a header line by line in the order that the format prescribes.
class HeaderReader {
 public:
  HeaderReader(const fs::path& file, std::string_view bytes) : file_(file), bytes_(bytes) {}

  PcdHeader read() {
    next();
    if (is("VERSION")) version();
    expect(is("FIELDS") || is("COLUMNS"), "FIELDS");
    names();
    expect(is("SIZE"), "SIZE");
    sizes();
    expect(is("TYPE"), "TYPE");
    types();
    if (is("COUNT")) counts();
    lay_out();
    expect(is("WIDTH"), "WIDTH");
    header_.width = int(extent());
    expect(is("HEIGHT"), "HEIGHT");
    header_.height = int(extent());
    if (is("VIEWPOINT")) next();  // where the sensor stood in the world: the points are in the camera frame
    expect(is("POINTS"), "POINTS");
    points();
    expect(is("DATA"), "DATA");
    data();
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
      // A line of a header is short: a long one is binary data or another kind of file.
      if (end == bytes_.npos || end - header_.body > 4096)
        fail("the PCD header breaks off here; the file is truncated or no point cloud, write it again");
      words_ = words_of(bytes_.substr(header_.body, end - header_.body));
      header_.body = end + 1;
      ++header_.lines;
    } while (words_.empty() || words_[0].starts_with('#'));
  }

  bool is(std::string_view key) const { return words_[0] == key; }

  void expect(bool found, const std::string& key) const {
    if (!found)
      fail("a PCD header has " + key + " here, not '" + std::string(words_[0].substr(0, 40)) + "'; correct the header");
  }

  std::optional<std::uint64_t> number(std::string_view word) const {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return value;
  }

  std::string listed(std::string_view word) const { return "'" + std::string(word.substr(0, 40)) + "'"; }

  void version() {
    const std::set<std::string_view> known{"0.6", ".6", "0.7", ".7"};
    if (words_.size() != 2 || !known.count(words_[1]))
      fail("only PCD versions 0.6 and 0.7 can be read; convert the file with PCL");
    next();
  }

  void names() {
    std::set<std::string_view> seen;
    for (std::size_t i = 1; i < words_.size(); ++i) {
      if (words_[i] != "_" && !seen.insert(words_[i]).second)
        fail("field " + listed(words_[i]) + " is there twice; correct the header");
      header_.fields.push_back({std::string(words_[i]), 'F', 4, 1, 0});
    }
    if (header_.fields.empty()) fail("FIELDS names no field; correct the header");
    next();
  }

  void expect_one_for_each_field() const {
    if (words_.size() != header_.fields.size() + 1)
      fail(std::string(words_[0]) + " has " + std::to_string(words_.size() - 1) + " entries for " +
           std::to_string(header_.fields.size()) + " fields; correct the header");
  }

  void sizes() {
    expect_one_for_each_field();
    for (std::size_t i = 1; i < words_.size(); ++i) {
      const auto size = number(words_[i]);
      if (size != 1u && size != 2u && size != 4u && size != 8u)
        fail("size " + listed(words_[i]) + " of field '" + header_.fields[i - 1].name + "' must be 1, 2, 4 or 8 bytes");
      header_.fields[i - 1].size = int(*size);
    }
    next();
  }

  void types() {
    expect_one_for_each_field();
    for (std::size_t i = 1; i < words_.size(); ++i) {
      PcdHeader::Field& field = header_.fields[i - 1];
      const bool known = words_[i] == "I" || words_[i] == "U" || (words_[i] == "F" && field.size >= 4);
      if (!known)
        fail("type " + listed(words_[i]) + " of field '" + field.name + "' with " + std::to_string(field.size) +
             " bytes must be I, U, or F with 4 or 8 bytes");
      field.type = words_[i][0];
    }
    next();
  }

  void counts() {
    constexpr std::uint64_t most = 1 << 16;
    expect_one_for_each_field();
    for (std::size_t i = 1; i < words_.size(); ++i) {
      const auto count = number(words_[i]);
      if (!count || *count < 1 || *count > most)
        fail("count " + listed(words_[i]) + " of field '" + header_.fields[i - 1].name + "' must be from 1 to 65536");
      header_.fields[i - 1].count = *count;
    }
    next();
  }

  void lay_out() {
    std::size_t offset = 0;
    for (PcdHeader::Field& field : header_.fields) {
      field.offset = offset;
      offset += field.bytes();
    }
  }

  std::uint64_t extent() {
    const auto value = words_.size() == 2 ? number(words_[1]) : std::nullopt;
    if (!value || *value < 1 || *value > most_points)
      fail(std::string(words_[0]) + " must be one whole number from 1 to 2^26; correct the header");
    next();
    return *value;
  }

  void points() {
    const std::uint64_t product = std::uint64_t(header_.width) * std::uint64_t(header_.height);
    const auto value = words_.size() == 2 ? number(words_[1]) : std::nullopt;
    if (value != product) fail("POINTS must be WIDTH x HEIGHT = " + std::to_string(product) + "; correct the header");
    if (product > most_points || product * header_.point_bytes() > most_bytes)
      fail("declares " + std::to_string(product) + " points of " + std::to_string(header_.point_bytes()) +
           " bytes; clouds of up to 2^26 points and 2^31 bytes can be read");
    next();
  }

  void data() {
    using Data = PcdHeader::Data;
    for (const Data kind : {Data::ascii, Data::binary, Data::binary_compressed})
      if (words_.size() == 2 && words_[1] == to_string(kind)) {
        header_.data = kind;
        return;
      }
    fail("DATA must be ascii, binary or binary_compressed; correct the header");
  }

  static constexpr std::uint64_t most_points = std::uint64_t{1} << 26;
  static constexpr std::uint64_t most_bytes = std::uint64_t{1} << 31;

  const fs::path& file_;
  std::string_view bytes_;
  std::vector<std::string_view> words_;
  PcdHeader header_;
};

}  // namespace

const PcdHeader::Field* PcdHeader::find(std::string_view name) const {
  const auto field = std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
  return field == fields.end() ? nullptr : &*field;
}

const char* to_string(PcdHeader::Data data) {
  return data == PcdHeader::Data::ascii ? "ascii" : data == PcdHeader::Data::binary ? "binary" : "binary_compressed";
}

PcdHeader parse_pcd_header(const fs::path& file, std::string_view bytes) { return HeaderReader(file, bytes).read(); }

PcdHeader read_pcd_header(const fs::path& file) { return parse_pcd_header(file, read_bytes(file, largest_cloud_file)); }

}  // namespace gestalt
