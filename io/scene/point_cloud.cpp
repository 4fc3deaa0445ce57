// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "point_cloud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"
#include "gestalt/io/scene/pcd_header.h"
#include "pcd_body.h"
#include "ply_body.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void reject_cloud(const fs::path& file, const std::string& what) {
  throw InputError(file.string() + ": " + what);
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

/// A field of any type as numbers; count must be 1.
class Numbers {
 public:
  Numbers(const std::string& points, const PcdHeader& header, const PcdHeader::Field& field)
      : elements_(points, header, field), type_(field.type), size_(field.size) {}

  double at(std::size_t point) const {
    if (type_ == 'F') return size_ == 4 ? double(elements_.at<float>(point)) : elements_.at<double>(point);
    if (type_ == 'U') return whole<std::uint8_t, std::uint16_t, std::uint32_t, std::uint64_t>(point);
    return whole<std::int8_t, std::int16_t, std::int32_t, std::int64_t>(point);
  }

 private:
  template <class One, class Two, class Four, class Eight>
  double whole(std::size_t point) const {
    return size_ == 1   ? double(elements_.at<One>(point))
           : size_ == 2 ? double(elements_.at<Two>(point))
           : size_ == 4 ? double(elements_.at<Four>(point))
                        : double(elements_.at<Eight>(point));
  }

  Elements elements_;
  char type_;
  int size_;
};

void take_points(const fs::path& file, const PcdHeader& header, const std::string& points, PointCloud& result) {
  result.points.resize(header.points());
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    const PcdHeader::Field* field = header.find(name);
    if (!field) reject_cloud(file, "has no field '" + name + "'; a cloud needs the fields x, y and z");
    if (field->type != 'F' || field->count != 1)
      reject_cloud(file, "field '" + name + "' must be one number of type F; write the cloud again");
    const Numbers numbers(points, header, *field);
    for (std::size_t i = 0; i < header.points(); ++i) result.points[i][axis] = float(numbers.at(i));
  }
}

/// Red, green and blue by the names that programs give them; null where one is missing.
std::array<const PcdHeader::Field*, 3> find_channels(const PcdHeader& header) {
  static constexpr std::array<std::array<const char*, 3>, 3> names{
      {{"red", "green", "blue"}, {"r", "g", "b"}, {"diffuse_red", "diffuse_green", "diffuse_blue"}}};
  for (const auto& [red, green, blue] : names) {
    const std::array found{header.find(red), header.find(green), header.find(blue)};
    if (found[0] && found[1] && found[2]) return found;
  }
  return {};
}

std::uint8_t byte_of(double value) { return std::uint8_t(std::lround(std::clamp(value, 0.0, 255.0))); }

/// What to multiply channels with for 0 to 255: floats are 0 to 1 as a rule, and 16-bit whole numbers take their range.
double channel_scale(const PcdHeader::Field& field, double largest) {
  if (field.type == 'F') return largest <= 1 ? 255 : 1;
  return field.size == 1 || largest <= 255 ? 1 : 255.0 / 65535;
}

void take_channels(const fs::path& file, const PcdHeader& header, const std::array<const PcdHeader::Field*, 3>& fields,
                   const std::string& points, PointCloud& result) {
  double least = 0, largest = 0;
  for (const PcdHeader::Field* field : fields) {
    if (field->count != 1) reject_cloud(file, "field '" + field->name + "' must be one number; write the cloud again");
    const Numbers numbers(points, header, *field);
    for (std::size_t i = 0; i < header.points(); ++i) {
      const double value = numbers.at(i);
      if (std::isfinite(value)) least = std::min(least, value), largest = std::max(largest, value);
    }
  }
  if (least < 0 || largest > 65535)
    reject_cloud(file, "field '" + fields[0]->name +
                           "' must be a colour from 0 to 1, to 255 or to 65535; write the cloud again");
  result.colours.resize(header.points());
  for (int channel = 0; channel < 3; ++channel) {
    const PcdHeader::Field& field = *fields[std::size_t(2 - channel)];  // blue first
    const Numbers numbers(points, header, field);
    const double scale = channel_scale(field, largest);
    for (std::size_t i = 0; i < header.points(); ++i) {
      const double value = numbers.at(i);
      if (std::isfinite(value)) result.colours[i][channel] = byte_of(scale * value);
    }
  }
}

/// How much came back of the sensor's light, as grey from the darkest to the brightest; single reflections may be far
/// brighter than all else.
void take_intensity(const PcdHeader& header, const PcdHeader::Field& field, const std::string& points,
                    PointCloud& result) {
  const Numbers numbers(points, header, field);
  std::vector<double> sorted;
  for (std::size_t i = 0; i < header.points(); ++i)
    if (const double value = numbers.at(i); std::isfinite(value) && result.visible(i)) sorted.push_back(value);
  if (sorted.empty()) return;
  const auto quantile = [&](double share) {
    const auto at = sorted.begin() + std::ptrdiff_t(share * double(sorted.size() - 1));
    std::nth_element(sorted.begin(), at, sorted.end());
    return *at;
  };
  const double low = quantile(0.01), high = quantile(0.99);
  result.colours.resize(header.points());
  for (std::size_t i = 0; i < header.points(); ++i) {
    const double value = numbers.at(i);
    const std::uint8_t grey = !std::isfinite(value) ? 0
                              : high > low          ? byte_of(255 * (value - low) / (high - low))
                                                    : 128;
    result.colours[i] = {grey, grey, grey};
  }
}

void take_colours(const fs::path& file, const PcdHeader& header, const std::string& points, PointCloud& result) {
  const auto channels = find_channels(header);
  if (channels[0]) return take_channels(file, header, channels, points, result);
  const PcdHeader::Field* field = header.find("rgb");
  if (!field) field = header.find("rgba");
  if (!field) {
    field = header.find("intensity");
    if (field && field->count == 1) take_intensity(header, *field, points, result);
    return;
  }
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
  constexpr double largest = 65535;
  const PcdHeader::Field* field = header.find("label");
  if (!field) return;
  if (field->count != 1) reject_cloud(file, "field 'label' must be one whole number; write the cloud again");
  const Numbers numbers(points, header, *field);
  result.labels.resize(header.points());
  for (std::size_t i = 0; i < header.points(); ++i) {
    const double label = numbers.at(i);
    if (std::isnan(label)) continue;  // of a point without a measurement: no label
    if (!(label >= 0 && label <= largest && label == std::floor(label)))
      reject_cloud(file,
                   "point " + std::to_string(i) +
                       " has a label that is not a whole number from 0 to 65535; write the cloud without the field "
                       "'label', or with labels as docs/formats.md says");
    result.labels[i] = std::uint16_t(label);
  }
}

/// From the points as a file's header lays them out.
PointCloud cloud_of(const fs::path& file, const PcdHeader& header, const std::string& points) {
  PointCloud result;
  result.width = header.width;
  result.height = header.height;
  result.viewpoint = header.viewpoint;
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
  const PcdHeader header = parse_pcd_header(file, bytes);
  return cloud_of(file, header, read_pcd_body(file, header, bytes));
}

PointCloud read_ply(const fs::path& file) {
  const std::string bytes = read_bytes(file, largest_cloud_file);
  const PlyHeader header = parse_ply_header(file, bytes);
  return cloud_of(file, header.vertices, read_ply_body(file, header, bytes));
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
