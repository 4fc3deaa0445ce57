// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "point_cloud.h"

#include <pcl/PCLPointCloud2.h>
#include <pcl/common/io.h>
#include <pcl/io/pcd_io.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "file_bytes.h"
#include "gestalt/error.h"
#include "gestalt/pcd_header.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& file, const std::string& what) { throw InputError(file.string() + ": " + what); }

/// Whether a word of an ascii cloud is a value of the field's type.
bool is_value(std::string_view word, const PcdHeader::Field& field) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const auto parses = [&](auto value, auto low, auto high) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc{} && end == word.data() + word.size() && !(value < low) && !(value > high);
  };
  if (field.type == 'F') {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const double largest = field.size == 4 ? std::numeric_limits<float>::max() : infinite;
    return parses(0.0, -largest, largest) || parses(0.0, infinite, infinite) || parses(0.0, -infinite, -infinite);
  }
  const int bits = 8 * field.size;
  if (field.type == 'U') return parses(std::uint64_t{0}, std::uint64_t{0}, ~std::uint64_t{0} >> (64 - bits));
  const std::int64_t high = std::numeric_limits<std::int64_t>::max() >> (64 - bits);
  return parses(std::int64_t{0}, -high - 1, high);
}

/// Checks that every point has a row with one value of the right type for each element, and gives the rows.
std::string_view check_ascii(const fs::path& file, const PcdHeader& header, std::string_view bytes) {
  constexpr std::string_view blank = " \t\r";
  const std::string_view body = bytes.substr(header.body);
  int line_number = header.lines;
  std::size_t at = 0;
  for (std::size_t point = 0; point < header.points();) {
    if (at >= body.size())
      fail(file, "has " + std::to_string(point) + " rows of points, the header promises " +
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
        if (word_at == line.npos) wrong("the row ends before field '" + field.name + "'");
        const std::size_t word_end = std::min(line.find_first_of(blank, word_at), line.size());
        const std::string_view word = line.substr(word_at, word_end - word_at);
        if (field.name != "_" && !is_value(word, field))
          wrong("'" + std::string(word.substr(0, 40)) + "' is no value of field '" + field.name + "' (" + field.type +
                std::to_string(field.size) + ")");
        word_at = line.find_first_not_of(blank, word_end);
      }
    if (word_at != line.npos) wrong("the row has more values than the header has fields");
    ++point;
  }
  return body.substr(0, at);
}

void check_binary(const fs::path& file, const PcdHeader& header, std::string_view bytes) {
  const std::size_t have = bytes.size() - header.body, need = header.points() * header.point_bytes();
  if (have < need)
    fail(file, "has " + std::to_string(have) + " bytes of points, the header promises " + std::to_string(need) +
                   "; the file is truncated, write it again");
}

/// Bytes that an LZF stream decompresses to; nothing when it refers to bytes before its start or breaks off. The stream
/// is literal runs (control byte below 32: its value + 1 bytes follow) and back references (upper 3 bits: length - 2,
/// 7 meaning that the next byte is added; lower 5 bits and one byte: distance - 1).
std::optional<std::size_t> decompressed_size(std::string_view stream) {
  const auto byte = [&](std::size_t i) { return std::size_t{static_cast<unsigned char>(stream[i])}; };
  std::size_t size = 0;
  for (std::size_t i = 0; i < stream.size();) {
    const std::size_t control = byte(i++);
    if (control < 32) {
      i += control + 1;
      size += control + 1;
      if (i > stream.size()) return std::nullopt;
      continue;
    }
    std::size_t length = control >> 5;
    if (i + (length == 7 ? 2 : 1) > stream.size()) return std::nullopt;
    if (length == 7) length += byte(i++);
    if (((control & 31) << 8 | byte(i++)) + 1 > size) return std::nullopt;
    size += length + 2;
  }
  return size;
}

void check_compressed(const fs::path& file, const PcdHeader& header, std::string_view bytes) {
  if (header.find("_"))
    fail(file, "has padding fields '_', which compressed clouds cannot have; write it as DATA binary");
  std::uint32_t sizes[2];  // compressed, uncompressed
  const std::size_t have = bytes.size() - header.body, need = header.points() * header.point_bytes();
  if (have >= sizeof sizes) std::memcpy(sizes, bytes.data() + header.body, sizeof sizes);
  if (have < sizeof sizes || have - sizeof sizes < sizes[0])
    fail(file, "has " + std::to_string(have) +
                   " bytes of compressed points, fewer than it promises; the file is "
                   "truncated, write it again");
  if (sizes[1] != need)
    fail(file, "promises " + std::to_string(sizes[1]) + " uncompressed bytes, its header " + std::to_string(need) +
                   "; header and data do not belong together, write it again");
  if (decompressed_size(bytes.substr(header.body + sizeof sizes, sizes[0])) != need)
    fail(file, "has damaged compressed data; copy or write it again");
}

/// Has PCL read the body under the header that was checked here.
pcl::PCLPointCloud2 read_body(const fs::path& file, const PcdHeader& header, std::string_view bytes) {
  pcl::PCLPointCloud2 cloud;
  cloud.width = pcl::uindex_t(header.width);
  cloud.height = pcl::uindex_t(header.height);
  cloud.point_step = pcl::uindex_t(header.point_bytes());
  cloud.row_step = cloud.point_step * cloud.width;
  for (const PcdHeader::Field& f : header.fields) {
    pcl::PCLPointField field;
    field.name = f.name;
    field.offset = pcl::uindex_t(f.offset);
    field.count = pcl::uindex_t(f.count);
    field.datatype = std::uint8_t(pcl::getFieldType(f.size, f.type));
    cloud.fields.push_back(std::move(field));
  }
  constexpr int version = pcl::PCDReader::PCD_V7;
  pcl::PCDReader reader;
  int result = 0;
  if (header.data == PcdHeader::Data::ascii) {
    const std::string_view rows = check_ascii(file, header, bytes);
    cloud.data.resize(header.points() * header.point_bytes());
    std::istringstream stream{std::string(rows)};
    result = reader.readBodyASCII(stream, cloud, version);
  } else {
    const bool compressed = header.data == PcdHeader::Data::binary_compressed;
    compressed ? check_compressed(file, header, bytes) : check_binary(file, header, bytes);
    cloud.data.resize(header.points() * header.point_bytes());
    result = reader.readBodyBinary(reinterpret_cast<const unsigned char*>(bytes.data()), cloud, version, compressed,
                                   unsigned(header.body));
  }
  if (result != 0) fail(file, "cannot be read by PCL; write it again");
  return cloud;
}

template <class T>
T element(const pcl::PCLPointCloud2& cloud, const PcdHeader::Field& field, std::size_t point) {
  T value;
  std::memcpy(&value, cloud.data.data() + point * cloud.point_step + field.offset, sizeof value);
  return value;
}

void take_points(const fs::path& file, const PcdHeader& header, const pcl::PCLPointCloud2& cloud, PointCloud& result) {
  result.points.resize(header.points());
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    const PcdHeader::Field* field = header.find(name);
    if (!field) fail(file, "has no field '" + name + "'; a cloud needs the fields x, y and z");
    if (field->type != 'F' || field->count != 1)
      fail(file, "field '" + name + "' must be one number of type F; write the cloud again");
    for (std::size_t i = 0; i < header.points(); ++i)
      result.points[i][axis] =
          field->size == 4 ? element<float>(cloud, *field, i) : float(element<double>(cloud, *field, i));
  }
}

void take_colours(const fs::path& file, const PcdHeader& header, const pcl::PCLPointCloud2& cloud, PointCloud& result) {
  const PcdHeader::Field* field = header.find("rgb");
  if (!field) field = header.find("rgba");
  if (!field) return;
  if (field->size != 4 || field->count != 1)
    fail(file, "field '" + field->name + "' must be one packed colour of 4 bytes; write the cloud again");
  result.colours.resize(header.points());
  // The colour is packed 0xAARRGGBB, whatever type the field declares.
  for (std::size_t i = 0; i < header.points(); ++i) {
    const auto packed = element<std::uint32_t>(cloud, *field, i);
    result.colours[i] = {std::uint8_t(packed), std::uint8_t(packed >> 8), std::uint8_t(packed >> 16)};
  }
}

void take_labels(const fs::path& file, const PcdHeader& header, const pcl::PCLPointCloud2& cloud, PointCloud& result) {
  const PcdHeader::Field* field = header.find("label");
  if (!field) return;
  if (field->type == 'F' || field->count != 1)
    fail(file, "field 'label' must be one whole number; write the cloud again");
  const auto read = [&](std::size_t i) -> std::uint64_t {
    switch (field->size) {
      case 1:
        return element<std::uint8_t>(cloud, *field, i);
      case 2:
        return element<std::uint16_t>(cloud, *field, i);
      case 4:
        return element<std::uint32_t>(cloud, *field, i);
      default:
        return element<std::uint64_t>(cloud, *field, i);
    }
  };
  // A negative label reads as a large one.
  const std::uint64_t largest = field->type == 'I' && field->size == 1   ? 127
                                : field->type == 'I' && field->size == 2 ? 32767
                                                                         : 65535;
  result.labels.resize(header.points());
  for (std::size_t i = 0; i < header.points(); ++i) {
    const std::uint64_t label = read(i);
    if (label > largest)
      fail(file, "point " + std::to_string(i) + " has a label outside 0 to " + std::to_string(largest) +
                     "; write the cloud without the field 'label', or with labels as docs/formats.md says");
    result.labels[i] = std::uint16_t(label);
  }
}

}  // namespace

bool PointCloud::visible(std::size_t i) const {
  const cv::Vec3f& p = points[i];
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) && p[2] > 0;
}

PointCloud read_point_cloud(const fs::path& file) {
  const std::string bytes = read_bytes(file);
  const PcdHeader header = parse_pcd_header(file, bytes);
  const pcl::PCLPointCloud2 cloud = read_body(file, header, bytes);
  PointCloud result;
  result.width = header.width;
  result.height = header.height;
  take_points(file, header, cloud, result);
  take_colours(file, header, cloud, result);
  take_labels(file, header, cloud, result);
  return result;
}

}  // namespace gestalt
