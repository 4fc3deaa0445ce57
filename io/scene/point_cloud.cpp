// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "point_cloud.h"

#include <liblzf/lzf.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"
#include "gestalt/io/scene/pcd_header.h"
#include "header_line.h"
#include "ply_header.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void reject_cloud(const fs::path& file, const std::string& what) {
  throw InputError(file.string() + ": " + what);
}

/// Takes a word of an ascii cloud for a value of the field's type and appends its bytes. False when it is none.
bool append_value(std::string_view word, const PcdHeader::Field& field, std::string& points) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const auto parse = [&](auto& value) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc{} && end == word.data() + word.size();
  };
  const auto append = [&](const auto& value) { points.append(reinterpret_cast<const char*>(&value), sizeof value); };
  if (field.type == 'F') {
    double value = 0;
    if (!parse(value)) return false;
    if (field.size == 8) return append(value), true;
    if (std::isfinite(value) && std::abs(value) > std::numeric_limits<float>::max()) return false;
    return append(float(value)), true;
  }
  // The lower bytes of the value: PCD files are little-endian, as x86 is.
  const int bits = 8 * field.size;
  std::uint64_t whole = 0;
  if (field.type == 'U') {
    if (!parse(whole) || whole > ~std::uint64_t{0} >> (64 - bits)) return false;
  } else {
    std::int64_t value = 0;
    const std::int64_t high = std::numeric_limits<std::int64_t>::max() >> (64 - bits);
    if (!parse(value) || value > high || value < -high - 1) return false;
    whole = std::uint64_t(value);
  }
  points.append(reinterpret_cast<const char*>(&whole), std::size_t(field.size));
  return true;
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
      reject_cloud(file, "has " + std::to_string(point) + " rows of points, the header promises " +
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
          wrong(shown(word) + " is no value of field " + shown(field.name) + " (" + field.type +
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
    reject_cloud(file, "has " + std::to_string(have) + " bytes of points, the header promises " + std::to_string(need) +
                           "; the file is truncated, write it again");
  return std::string(bytes.substr(header.body, need));
}

/// Bytes that LZF makes of one at most: three name 264 earlier ones.
constexpr std::size_t most_expanded = 88;

/// Compressed by LZF are the first elements' values of all points, then the second ones', and so on.
std::string read_compressed(const fs::path& file, const PcdHeader& header, std::string_view bytes) {
  if (header.find("_"))
    reject_cloud(file, "has padding fields '_', which compressed clouds cannot have; write it as DATA binary");
  std::uint32_t sizes[2];  // compressed, uncompressed
  const std::size_t have = bytes.size() - header.body, need = header.points() * header.point_bytes();
  if (have >= sizeof sizes) std::memcpy(sizes, bytes.data() + header.body, sizeof sizes);
  if (have < sizeof sizes || have - sizeof sizes < sizes[0])
    reject_cloud(file, "has " + std::to_string(have) +
                           " bytes of compressed points, fewer than it promises; the file is "
                           "truncated, write it again");
  if (sizes[1] != need)
    reject_cloud(file, "promises " + std::to_string(sizes[1]) + " uncompressed bytes, its header " +
                           std::to_string(need) + "; header and data do not belong together, write it again");
  if (need / most_expanded > sizes[0])
    reject_cloud(file, "promises " + std::to_string(need) + " bytes of points, more than its " +
                           std::to_string(sizes[0]) + " compressed ones can be; write it again");
  std::string fields(need, '\0');
  if (lzf_decompress(bytes.data() + header.body + sizeof sizes, sizes[0], fields.data(), unsigned(need)) != need)
    reject_cloud(file, "has damaged compressed data; copy or write it again");
  std::string points(need, '\0');
  std::size_t from = 0;
  for (const PcdHeader::Field& field : header.fields)
    for (std::size_t point = 0; point < header.points(); ++point, from += field.bytes())
      std::memcpy(&points[point * header.point_bytes() + field.offset], &fields[from], field.bytes());
  return points;
}

/// The points one after another, each as the header lays it out.
std::string read_body(const fs::path& file, const PcdHeader& header, std::string_view bytes) {
  switch (header.data) {
    case PcdHeader::Data::ascii:
      return read_ascii(file, header, bytes);
    case PcdHeader::Data::binary:
      return read_binary(file, header, bytes);
    default:
      return read_compressed(file, header, bytes);
  }
}

/// The elements of a field, point by point.
class Elements {
 public:
  Elements(const std::string& points, const PcdHeader& header, const PcdHeader::Field& field)
      : first_(points.data() + field.offset), step_(header.point_bytes()) {}

  template <class T>
  T at(std::size_t point) const {
    T value;
    std::memcpy(&value, first_ + point * step_, sizeof value);
    return value;
  }

 private:
  const char* first_;
  std::size_t step_;
};

void take_points(const fs::path& file, const PcdHeader& header, const std::string& points, PointCloud& result) {
  result.points.resize(header.points());
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    const PcdHeader::Field* field = header.find(name);
    if (!field) reject_cloud(file, "has no field '" + name + "'; a cloud needs the fields x, y and z");
    if (field->type != 'F' || field->count != 1)
      reject_cloud(file, "field '" + name + "' must be one number of type F; write the cloud again");
    const Elements elements(points, header, *field);
    for (std::size_t i = 0; i < header.points(); ++i)
      result.points[i][axis] = field->size == 4 ? elements.at<float>(i) : float(elements.at<double>(i));
  }
}

/// Of fields red, green and blue, as PLY files have them.
void take_channels(const fs::path& file, const PcdHeader& header, const std::string& points, PointCloud& result) {
  static constexpr std::array<const char*, 3> names{"blue", "green", "red"};
  for (int channel = 0; channel < 3; ++channel) {
    const PcdHeader::Field* field = header.find(names[std::size_t(channel)]);
    if (!field) return;
    if (field->type != 'U' || field->size != 1 || field->count != 1)
      reject_cloud(file, "property '" + field->name + "' must be of type uchar; write the cloud again");
    result.colours.resize(header.points());
    const Elements elements(points, header, *field);
    for (std::size_t i = 0; i < header.points(); ++i) result.colours[i][channel] = elements.at<std::uint8_t>(i);
  }
}

void take_colours(const fs::path& file, const PcdHeader& header, const std::string& points, PointCloud& result) {
  if (header.find("red") && header.find("green") && header.find("blue"))
    return take_channels(file, header, points, result);
  const PcdHeader::Field* field = header.find("rgb");
  if (!field) field = header.find("rgba");
  if (!field) return;
  if (field->size != 4 || field->count != 1)
    reject_cloud(file, "field '" + field->name + "' must be one packed colour of 4 bytes; write the cloud again");
  result.colours.resize(header.points());
  const Elements elements(points, header, *field);
  // The colour is packed 0xAARRGGBB, whatever type the field declares.
  for (std::size_t i = 0; i < header.points(); ++i) {
    const auto packed = elements.at<std::uint32_t>(i);
    result.colours[i] = {std::uint8_t(packed), std::uint8_t(packed >> 8), std::uint8_t(packed >> 16)};
  }
}

void take_labels(const fs::path& file, const PcdHeader& header, const std::string& points, PointCloud& result) {
  const PcdHeader::Field* field = header.find("label");
  if (!field) return;
  if (field->type == 'F' || field->count != 1)
    reject_cloud(file, "field 'label' must be one whole number; write the cloud again");
  const Elements elements(points, header, *field);
  const auto read = [&](std::size_t i) -> std::uint64_t {
    switch (field->size) {
      case 1:
        return elements.at<std::uint8_t>(i);
      case 2:
        return elements.at<std::uint16_t>(i);
      case 4:
        return elements.at<std::uint32_t>(i);
      default:
        return elements.at<std::uint64_t>(i);
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
      reject_cloud(file, "point " + std::to_string(i) + " has a label outside 0 to " + std::to_string(largest) +
                             "; write the cloud without the field 'label', or with labels as docs/formats.md says");
    result.labels[i] = std::uint16_t(label);
  }
}

PointCloud read_points(const fs::path& file, const PcdHeader& header, std::string_view bytes) {
  const std::string points = read_body(file, header, bytes);
  PointCloud result;
  result.width = header.width;
  result.height = header.height;
  take_points(file, header, points, result);
  take_colours(file, header, points, result);
  take_labels(file, header, points, result);
  return result;
}

}  // namespace

bool PointCloud::visible(std::size_t i) const {
  const cv::Vec3f& p = points[i];
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) && p[2] > 0;
}

PointCloud read_pcd(const fs::path& file) {
  const std::string bytes = read_bytes(file, largest_cloud_file);
  return read_points(file, parse_pcd_header(file, bytes), bytes);
}

PointCloud read_ply(const fs::path& file) {
  const std::string bytes = read_bytes(file, largest_cloud_file);
  return read_points(file, parse_ply_header(file, bytes), bytes);
}

std::string encode_pcd(const PointCloud& cloud) {
  std::string fields = "x y z", sizes = "4 4 4", types = "F F F", counts = "1 1 1";
  const auto field = [&](const char* name) {
    fields += std::string(" ") + name;
    sizes += " 4", types += " U", counts += " 1";
  };
  if (!cloud.colours.empty()) field("rgb");
  if (!cloud.labels.empty()) field("label");
  std::string bytes = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " + sizes +
                      "\nTYPE " + types + "\nCOUNT " + counts + "\nWIDTH " + std::to_string(cloud.width) + "\nHEIGHT " +
                      std::to_string(cloud.height) + "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
                      std::to_string(cloud.points.size()) + "\nDATA binary\n";
  const auto append = [&](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    append(cloud.points[i]);
    if (!cloud.colours.empty()) {
      const cv::Vec3b& colour = cloud.colours[i];
      append(std::uint32_t(colour[2]) << 16 | std::uint32_t(colour[1]) << 8 | std::uint32_t(colour[0]));
    }
    if (!cloud.labels.empty()) append(std::uint32_t(cloud.labels[i]));
  }
  return bytes;
}

}  // namespace gestalt
