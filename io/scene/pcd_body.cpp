// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "pcd_body.h"

#include <liblzf/lzf.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "ascii_value.h"
#include "gestalt/core/base/error.h"
#include "header_line.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void reject_body(const fs::path& file, const std::string& what) {
  throw InputError(file.string() + ": " + what);
}

/// Every point must have a row with one value of the right type for each element.
std::string read_ascii(const fs::path& file, const PcdHeader& header, std::string_view bytes) {
  constexpr std::string_view blank = " \t\r";
  const std::string_view body = bytes.substr(header.body);
  std::string points;
  int line_number = header.lines;
  std::size_t at = 0;
  for (std::size_t point = 0; point < header.points();) {
    if (at >= body.size())
      reject_body(file, "has " + std::to_string(point) + " rows of points, the header declares " +
                            std::to_string(header.points()) + "; the file is truncated, write it again");
    const std::size_t end = std::min(body.find('\n', at), body.size());
    const std::string_view line = body.substr(at, end - at);
    at = std::min(end + 1, body.size());
    ++line_number;
    if (line.empty()) continue;

    const auto wrong = [&](const std::string& what) {
      throw InputError(file.string() + ":" + std::to_string(line_number) + ": " + what + "; correct the row");
    };
    std::size_t word_at = line.find_first_not_of(blank);
    for (const PcdHeader::Field& field : header.fields)
      for (std::size_t i = 0; i < field.count; ++i) {
        if (word_at == line.npos) wrong("the row ends before field " + shown(field.name));
        const std::size_t word_end = std::min(line.find_first_of(blank, word_at), line.size());
        const std::string_view word = line.substr(word_at, word_end - word_at);
        if (field.name == "_")
          points.append(std::size_t(field.size), '\0');
        else if (!append_value(word, field, points))
          wrong(shown(word) + " is not a value of field " + shown(field.name) + " (" + field.type +
                std::to_string(field.size) + ")");
        word_at = line.find_first_not_of(blank, word_end);
      }
    if (word_at != line.npos) wrong("the row has more values than the header has fields");
    ++point;
  }
  return points;
}

std::string read_binary(const fs::path& file, const PcdHeader& header, std::string_view bytes) {
  const std::size_t have = bytes.size() - header.body, need = header.points() * header.point_bytes();
  if (have < need)
    reject_body(file, "has " + std::to_string(have) + " bytes of points, the header declares " + std::to_string(need) +
                          "; the file is truncated, write it again");
  return std::string(bytes.substr(header.body, need));
}

/// Bytes that LZF makes of one at most: three name 264 earlier ones.
constexpr std::size_t most_expanded = 88;

/// Compressed by LZF are the first elements' values of all points, then the second ones', and so on.
std::string read_compressed(const fs::path& file, const PcdHeader& header, std::string_view bytes) {
  if (header.find("_"))
    reject_body(file, "has padding fields '_', which compressed clouds cannot have; write it as DATA binary");
  std::uint32_t sizes[2];  // compressed, uncompressed
  const std::size_t have = bytes.size() - header.body, need = header.points() * header.point_bytes();
  if (have >= sizeof sizes) std::memcpy(sizes, bytes.data() + header.body, sizeof sizes);
  if (have < sizeof sizes || have - sizeof sizes < sizes[0])
    reject_body(file, "has " + std::to_string(have) +
                          " bytes of compressed points, fewer than it declares; the file is "
                          "truncated, write it again");
  if (sizes[1] != need)
    reject_body(file, "declares " + std::to_string(sizes[1]) + " uncompressed bytes, its header " +
                          std::to_string(need) + "; header and data do not match, write it again");
  if (need / most_expanded > sizes[0])
    reject_body(file, "declares " + std::to_string(need) + " bytes of points, more than its " +
                          std::to_string(sizes[0]) + " compressed bytes can hold; write it again");
  std::string fields(need, '\0');
  if (lzf_decompress(bytes.data() + header.body + sizeof sizes, sizes[0], fields.data(), unsigned(need)) != need)
    reject_body(file, "has damaged compressed data; copy or write it again");
  std::string points(need, '\0');
  std::size_t from = 0;
  for (const PcdHeader::Field& field : header.fields)
    for (std::size_t point = 0; point < header.points(); ++point, from += field.bytes())
      std::memcpy(&points[point * header.point_bytes() + field.offset], &fields[from], field.bytes());
  return points;
}

}  // namespace

std::string read_pcd_body(const fs::path& file, const PcdHeader& header, std::string_view bytes) {
  switch (header.data) {
    case PcdHeader::Data::ascii:
      return read_ascii(file, header, bytes);
    case PcdHeader::Data::binary:
      return read_binary(file, header, bytes);
    default:
      return read_compressed(file, header, bytes);
  }
}

}  // namespace gestalt
