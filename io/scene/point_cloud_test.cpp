// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <pcl/PCLPointCloud2.h>
#include <pcl/common/io.h>
#include <pcl/io/pcd_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/input.h"
#include "gestalt/io/scene/pcd_header.h"
#include "gestalt/tests/environment/decimal_comma.h"
#include "gestalt/tests/environment/temporary_folder.h"

namespace gestalt {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

struct Point {
  float x, y, z;
  std::uint32_t colour = 0x00102030;  // red 0x10, green 0x20, blue 0x30
  std::uint32_t label = 0;
};

/// A field as the file shall have it: name, type, size.
struct FieldSpec {
  std::string name;
  char type;
  int size;
};

template <class T>
void append(std::vector<std::uint8_t>& bytes, T value) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(&value);
  bytes.insert(bytes.end(), first, first + sizeof value);
}

pcl::PCLPointCloud2 cloud_of(const std::vector<Point>& points, int width, const std::vector<FieldSpec>& fields) {
  pcl::PCLPointCloud2 cloud;
  cloud.width = pcl::uindex_t(width);
  cloud.height = pcl::uindex_t(points.size()) / cloud.width;
  for (const FieldSpec& spec : fields) {
    pcl::PCLPointField field;
    field.name = spec.name;
    field.offset = cloud.point_step;
    field.count = 1;
    field.datatype = std::uint8_t(pcl::getFieldType(spec.size, spec.type));
    cloud.point_step += pcl::uindex_t(spec.size);
    cloud.fields.push_back(field);
  }
  cloud.row_step = cloud.point_step * cloud.width;
  for (const Point& p : points)
    for (const FieldSpec& spec : fields) {
      const float position = spec.name == "x" ? p.x : spec.name == "y" ? p.y : p.z;
      const std::uint32_t whole = spec.name == "label" ? p.label : p.colour;
      if (spec.name == "x" || spec.name == "y" || spec.name == "z")
        spec.size == 8 ? append(cloud.data, double(position)) : append(cloud.data, position);
      else if (spec.size == 1)
        append(cloud.data, std::uint8_t(whole));
      else if (spec.size == 2)
        append(cloud.data, std::uint16_t(whole));
      else
        append(cloud.data, whole);
    }
  return cloud;
}

const Camera camera_8x6{8, 6, 10, 12, 3.5, 2.25};

/// An organized cloud as camera_8x6 sees it, wavy so that all depths differ; the point at (2, 1) has no measurement.
std::vector<Point> seen_points() {
  std::vector<Point> points;
  for (int v = 0; v < 6; ++v)
    for (int u = 0; u < 8; ++u) {
      const float z = 1 + 0.01f * float(u * u) + 0.02f * float(v);
      const bool valid = u != 2 || v != 1;
      points.push_back({valid ? float((u - camera_8x6.cx) / camera_8x6.fx) * z : nan,
                        valid ? float((v - camera_8x6.cy) / camera_8x6.fy) * z : nan, valid ? z : nan,
                        std::uint32_t(0xff000000 | u << 16 | v << 8 | 99), std::uint32_t(20 + u)});
    }
  return points;
}

std::string error_of(const fs::path& file, const std::optional<CameraFile>& camera = std::nullopt) {
  testing::internal::CaptureStderr();
  std::string message;
  try {
    read_scene(file, camera);
  } catch (const InputError& error) {
    message = error.what();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_NE(message, "") << "no InputError was thrown";
  return message;
}

void expect_parts(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_NE(message.find(part), message.npos) << part << "\nin: " << message;
}

void expect_seen_points(const Input& input, bool colour, bool labels) {
  const std::vector<Point> points = seen_points();
  ASSERT_EQ(input.frame.width(), 8);
  ASSERT_EQ(input.frame.height(), 6);
  EXPECT_EQ(input.frame.has_colour(), colour);
  EXPECT_EQ(!input.ground_truth.empty(), labels);
  EXPECT_TRUE(input.point_pixels.empty());
  for (int i = 0; i < 48; ++i) {
    const Point& p = points[std::size_t(i)];
    if (i == 1 * 8 + 2) {
      EXPECT_FALSE(input.frame.valid(i));
      continue;
    }
    EXPECT_NEAR(input.frame.point(i).x(), p.x, 1e-5);
    EXPECT_NEAR(input.frame.point(i).y(), p.y, 1e-5);
    EXPECT_NEAR(input.frame.point(i).z(), p.z, 1e-6);
    if (colour) {
      EXPECT_EQ(input.frame.colour.at<cv::Vec3b>(i / 8, i % 8),
                cv::Vec3b(99, std::uint8_t(i / 8), std::uint8_t(i % 8)));
    }
    if (labels) {
      EXPECT_EQ(input.ground_truth(i / 8, i % 8), 20 + i % 8);
    }
  }
}

// A file of each data kind written by PCL.
class Written : public testing::TestWithParam<std::string> {
 protected:
  fs::path write(const pcl::PCLPointCloud2& cloud) const {
    fs::path file = folder_.path() / "c.pcd";
    pcl::PCDWriter writer;
    const Eigen::Vector4f origin = Eigen::Vector4f::Zero();
    const Eigen::Quaternionf turn = Eigen::Quaternionf::Identity();
    const int result = GetParam() == "ascii"    ? writer.writeASCII(file.string(), cloud, origin, turn, 9)
                       : GetParam() == "binary" ? writer.writeBinary(file.string(), cloud, origin, turn)
                                                : writer.writeBinaryCompressed(file.string(), cloud, origin, turn);
    EXPECT_EQ(result, 0);
    EXPECT_EQ(to_string(read_pcd_header(file).data), GetParam());
    return file;
  }

  Input round_trip(const std::vector<FieldSpec>& fields) const {
    return read_scene(write(cloud_of(seen_points(), 8, fields)));
  }

  TemporaryFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(Pcd, Written, testing::Values("ascii", "binary", "binary_compressed"),
                         [](const auto& kind) { return kind.param; });

TEST_P(Written, OrganizedCloudGivesItsPointsBack) {
  expect_seen_points(round_trip({{"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}, {"rgb", 'F', 4}}), true, false);
  expect_seen_points(round_trip({{"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}}), false, false);
}

TEST_P(Written, FieldsMayHaveAnyOrderAndType) {
  expect_seen_points(round_trip({{"label", 'U', 4}, {"z", 'F', 4}, {"rgba", 'U', 4}, {"y", 'F', 4}, {"x", 'F', 4}}),
                     true, true);
  expect_seen_points(round_trip({{"label", 'U', 2}, {"rgb", 'U', 4}, {"x", 'F', 8}, {"y", 'F', 8}, {"z", 'F', 8}}),
                     true, true);
  expect_seen_points(
      round_trip({{"extra", 'I', 2}, {"x", 'F', 4}, {"y", 'F', 4}, {"label", 'U', 1}, {"z", 'F', 4}, {"more", 'U', 1}}),
      false, true);
}

TEST_P(Written, CameraIsFittedToOrganizedPoints) {
  const Camera c = round_trip({{"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}}).frame.camera;
  EXPECT_EQ(c.width, 8);
  EXPECT_EQ(c.height, 6);
  EXPECT_NEAR(c.fx, 10, 1e-4);
  EXPECT_NEAR(c.fy, 12, 1e-4);
  EXPECT_NEAR(c.cx, 3.5, 1e-4);
  EXPECT_NEAR(c.cy, 2.25, 1e-4);
}

TEST_P(Written, ReadsTheSameUnderADecimalComma) {
  const fs::path file = write(cloud_of(seen_points(), 8, {{"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}}));
  const test::DecimalComma comma;
  expect_seen_points(read_scene(file), false, false);
}

// In the 8x6 camera the first three points share pixel (3, 2), in an order in which the nearest is neither first nor
// last; then one left of the image, one behind the camera, one without position, and one in the corner (7, 5).
std::vector<Point> loose_points() {
  const auto at = [](double u, double v, float z) {
    return Point{float((u - camera_8x6.cx) / camera_8x6.fx) * z, float((v - camera_8x6.cy) / camera_8x6.fy) * z, z};
  };
  std::vector<Point> points{at(3, 2, 2),  at(3.3, 1.8, 1), at(2.6, 2.4, 1.5), at(-0.6, 2, 1),
                            at(3, 2, -1), {nan, nan, nan}, at(7.4, 5.4, 3)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].colour = std::uint32_t(i);
    points[i].label = std::uint32_t(30 + i);
  }
  return points;
}

TEST_P(Written, UnorganizedCloudIsProjected) {
  const fs::path file = write(
      cloud_of(loose_points(), 7, {{"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}, {"rgba", 'U', 4}, {"label", 'U', 4}}));
  const Input input = read_scene(file, camera_8x6);
  const int shared = 2 * 8 + 3, corner = 5 * 8 + 7;
  EXPECT_EQ(input.point_pixels, (std::vector<int>{shared, shared, shared, -1, -1, -1, corner}));
  EXPECT_EQ(input.frame.width(), 8);
  EXPECT_EQ(input.frame.height(), 6);
  EXPECT_EQ(cv::countNonZero(input.frame.depth), 2);
  EXPECT_EQ(input.frame.depth(2, 3), 1.0f);
  EXPECT_EQ(input.frame.colour.at<cv::Vec3b>(2, 3), cv::Vec3b(1, 0, 0));
  EXPECT_EQ(input.ground_truth(2, 3), 31);
  EXPECT_EQ(input.frame.depth(5, 7), 3.0f);
  EXPECT_EQ(input.ground_truth(5, 7), 36);
  EXPECT_EQ(input.ground_truth(0, 0), 0);
}

TEST_P(Written, CutAnywhereIsRefused) {
  const fs::path file =
      write(cloud_of(seen_points(), 8, {{"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}, {"label", 'U', 4}}));
  std::string whole = test::content(file);
  // PCL pads binary files; of an ascii file the last line end may go, and the last digit is not missed.
  const PcdHeader header = read_pcd_header(file);
  if (GetParam() == "binary") whole.resize(header.body + header.points() * header.point_bytes());
  if (GetParam() == "binary_compressed") {
    std::uint32_t compressed = 0;
    std::memcpy(&compressed, whole.data() + header.body, sizeof compressed);
    whole.resize(header.body + 8 + compressed);
  }
  if (GetParam() == "ascii") whole.resize(whole.find_last_of(' ') + 1);
  for (std::size_t size = 1; size < whole.size(); size += 7) {
    folder_.write("c.pcd", whole.substr(0, size));
    expect_parts(error_of(file), {"c.pcd", ";"});
  }
}

class Pcd : public testing::Test {
 protected:
  fs::path write(const std::string& text) const { return folder_.write("c.pcd", text); }

  /// A small correct ascii cloud with one thing replaced.
  fs::path write_with(const std::string& part, const std::string& replacement) const {
    std::string text =
        "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 2\n"
        "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA ascii\n0 0 1\n0.5 0 1\n0 0.25 1\n0.5 0.25 1\n";
    const std::size_t at = text.find(part);
    EXPECT_NE(at, text.npos);
    return write(text.replace(at, part.size(), replacement));
  }

  void expect_refusal(const std::string& part, const std::string& replacement,
                      const std::vector<std::string>& parts) const {
    expect_parts(error_of(write_with(part, replacement)), parts);
  }

  TemporaryFolder folder_;
};

TEST_F(Pcd, ReadsWhatOtherProgramsWrite) {
  const auto expect_fit = [](const fs::path& file) {
    const Input input = read_scene(file);
    EXPECT_NEAR(input.frame.camera.fx, 2, 1e-6);
    EXPECT_NEAR(input.frame.camera.fy, 4, 1e-6);
    EXPECT_EQ(input.frame.name, "c");
  };
  expect_fit(write_with("# .PCD v0.7\nVERSION 0.7\nFIELDS", "# .PCD v.5\n# by hand\n\nVERSION .6\nCOLUMNS"));
  expect_fit(write_with("COUNT 1 1 1\n", ""));
  expect_fit(write_with("VIEWPOINT 0 0 0 1 0 0 0\n", ""));
  expect_fit(write_with("0.5 0 1\n", "\n  +5e-1\t0   1.0\r\n"));
  expect_fit(write_with("0.5 0.25 1\n", "0.5 0.25 1"));
  expect_fit(write_with("0.5 0.25 1\n", "0.5 0.25 1\n\nwhatever follows\n"));
  expect_fit(write_with("0.5 0.25 1", "NaN -nan inf"));
}

TEST_F(Pcd, RefusesAWrongHeader) {
  expect_refusal("VERSION 0.7", "VERSION 0.4", {"c.pcd:2: ", "versions 0.5, 0.6 and 0.7"});
  expect_refusal("FIELDS x y z", "FIELDS", {"c.pcd:3: ", "names no field"});
  expect_refusal("FIELDS x y z", "FIELDS x x z", {"c.pcd:3: ", "'x' appears twice"});
  expect_refusal("FIELDS x y z", "FIELDS x y w", {"c.pcd: has no field 'z'"});
  expect_refusal("SIZE 4 4 4", "SIZE 4 4", {"c.pcd:4: SIZE has 2 entries for 3 fields"});
  expect_refusal("SIZE 4 4 4", "SIZE 4 4 3", {"c.pcd:4: size '3' of field 'z'"});
  expect_refusal("SIZE 4 4 4", "SIZE 4 4 -4", {"c.pcd:4: size '-4'"});
  expect_refusal("SIZE 4 4 4", "SIZE 4 4 2", {"c.pcd:5: type 'F' of field 'z' with 2 bytes"});
  expect_refusal("TYPE F F F", "TYPE F F Q", {"c.pcd:5: type 'Q' of field 'z'"});
  expect_refusal("TYPE F F F", "TYPE F F U", {"c.pcd: field 'z' must be one number of type F"});
  expect_refusal(
      "COUNT 1 1 1\nWIDTH 2\nHEIGHT 2\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA ascii\n0 0 1\n0.5 0 1\n0 0.25 1\n0.5 "
      "0.25 1",
      "COUNT 1 1 0\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n0 0\n1 1", {"c.pcd: has no field 'z'"});
  expect_refusal("COUNT 1 1 1", "COUNT 1 1 99999999999999999999", {"c.pcd:6: count '9999"});
  expect_refusal("WIDTH 2", "WIDTH -2", {"c.pcd:7: WIDTH must be"});
  expect_refusal("WIDTH 2", "WIDTH 0", {"c.pcd:7: WIDTH must be"});
  expect_refusal("HEIGHT 2", "HEIGHT 99999999999999999999", {"c.pcd:8: HEIGHT must be"});
  expect_refusal("HEIGHT 2", "HEIGHT 3", {"c.pcd:10: POINTS must be WIDTH x HEIGHT = 6"});
  expect_refusal("HEIGHT 2\n", "", {"c.pcd:8: a PCD header has HEIGHT here, not 'VIEWPOINT'"});
  expect_refusal("POINTS 4", "POINTS 5", {"c.pcd:10: POINTS must be WIDTH x HEIGHT = 4"});
  expect_refusal("DATA ascii", "DATA text", {"c.pcd:11: DATA must be ascii, binary or binary_compressed"});
  expect_refusal("DATA ascii\n0 0 1", "DATA ascii", {"c.pcd: has 3 rows of points, the header declares 4"});
}

TEST_F(Pcd, RefusesMorePointsThanTheFileHolds) {
  const auto huge = [](const std::string& data) {
    return "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 8192\nHEIGHT 8192\nPOINTS 67108864\nDATA " + data;
  };
  expect_parts(error_of(write(huge("ascii\n0 0 1\n"))), {"has 1 rows", "declares 67108864"});
  expect_parts(error_of(write(huge("binary\n0123"))), {"has 4 bytes", "declares 805306368", "truncated"});
  expect_parts(error_of(write(huge("binary_compressed\n0123"))), {"has 4 bytes of compressed points"});
  const std::string promised("\x02\0\0\0\0\0\0\x30\0x", 10);
  expect_parts(error_of(write(huge("binary_compressed\n" + promised))),
               {"declares 805306368 bytes", "more than its 2 compressed bytes"});
  expect_parts(error_of(write_with("WIDTH 2\nHEIGHT 2\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4",
                                   "WIDTH 67108864\nHEIGHT 67108864\nPOINTS 4503599627370496")),
               {"c.pcd:9: ", "2^26"});
}

TEST_F(Pcd, WhatAFileSaysDoesNotCommandTheTerminal) {
  expect_parts(error_of(write("VERSION 0.7\nFIELDS x \x1b[2J \x1b[2J\n")), {"c.pcd:2: field '?[2J'"});
  expect_parts(error_of(write("VERSION 0.7\nFIELDS \x1b[2J\nSIZE 3\n")), {"c.pcd:3: size '3' of field '?[2J' must"});
  expect_refusal("0.5 0 1", "0.5 \x1b[2J 1", {"c.pcd:13: '?[2J' is not a value of field 'y' (F4)"});
}

TEST_F(Pcd, RefusesRowsThatDoNotFitTheFields) {
  expect_refusal("0.5 0 1", "0.5 0", {"c.pcd:13: the row ends before field 'z'"});
  expect_refusal("0.5 0 1", "0.5 0 1 7", {"c.pcd:13: the row has more values"});
  expect_refusal("0.5 0 1", "0,5 0 1", {"c.pcd:13: '0,5' is not a value of field 'x' (F4)"});
  expect_refusal("0.5 0 1", "0.5 0 1e39", {"c.pcd:13: '1e39' is not a value of field 'z' (F4)"});
  expect_parts(
      error_of(write("FIELDS x y z label\nSIZE 4 4 4 1\nTYPE F F F U\nWIDTH 1\nHEIGHT 2\nPOINTS 2\nDATA ascii\n"
                     "0 0 1 255\n0 0 1 256\n")),
      {"c.pcd:9: '256' is not a value of field 'label' (U1)"});
}

TEST_F(Pcd, RefusesLabelsThatAreNone) {
  const std::string header =
      "FIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F I\nWIDTH 1\nHEIGHT 2\nPOINTS 2\nDATA ascii\n";
  expect_parts(error_of(write(header + "0 0 1 1\n0 0 1 -1\n")),
               {"point 1 has a label that is not a whole number from 0 to 65535"});
  expect_parts(error_of(write(header + "0 0 1 70000\n0 0 1 1\n")),
               {"point 0 has a label that is not a whole number from 0 to 65535"});
}

TEST_F(Pcd, ReadsLabelsOfAnySize) {
  for (const char* size : {"1", "2", "4", "8"})
    for (const char* type : {"U", "I"}) {
      const Input input =
          read_scene(write("FIELDS x y z label\nSIZE 4 4 4 " + std::string(size) + "\nTYPE F F F " + type +
                           "\nWIDTH 2\nHEIGHT 2\nPOINTS 4\nDATA ascii\n"
                           "0 0 1 0\n0.5 0 1 1\n0 0.25 1 20\n0.5 0.25 1 127\n"));
      const cv::Mat_<std::uint16_t> expected = (cv::Mat_<std::uint16_t>(2, 2) << 0, 1, 20, 127);
      EXPECT_EQ(cv::norm(input.ground_truth, expected, cv::NORM_INF), 0) << type << size << input.ground_truth;
    }
}

TEST_F(Pcd, RefusesColoursAndLabelsOfAnotherKind) {
  const auto with_field = [&](const std::string& name, const std::string& size, const std::string& type) {
    return write("FIELDS x y z " + name + "\nSIZE 4 4 4 " + size + "\nTYPE F F F " + type +
                 "\nWIDTH 2\nHEIGHT 2\nPOINTS 4\nDATA ascii\n0 0 1 1\n0.5 0 1 1\n0 0.25 1 1\n0.5 0.25 1 1\n");
  };
  expect_parts(error_of(with_field("rgb", "8", "F")), {"c.pcd: field 'rgb' must be one packed colour of 4 bytes"});
  expect_parts(error_of(with_field("rgba", "2", "U")), {"c.pcd: field 'rgba' must be one packed colour of 4 bytes"});
  expect_parts(
      error_of(write("FIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F F\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n"
                     "0 0 1 1\n0.5 0 1 1.5\n")),
      {"c.pcd: point 1 has a label that is not a whole number"});
}

// A cloud of 2x2 points with fields beside x, y, z; each has a row of its values for the four points.
class OtherFields : public Pcd {
 protected:
  Input read(const std::string& fields, const std::string& sizes, const std::string& types,
             const std::array<const char*, 4>& rows) const {
    std::string text = "FIELDS x y z " + fields + "\nSIZE 4 4 4 " + sizes + "\nTYPE F F F " + types +
                       "\nWIDTH 2\nHEIGHT 2\nPOINTS 4\nDATA ascii\n";
    const std::array<const char*, 4> positions{"0 0 1 ", "0.5 0 1 ", "0 0.25 1 ", "0.5 0.25 1 "};
    for (std::size_t i = 0; i < 4; ++i) text += std::string(positions[i]) + rows[i] + "\n";
    return read_scene(write(text));
  }
};

TEST_F(OtherFields, ColourMayBeThreeFields) {
  for (const char* names : {"red green blue", "r g b", "diffuse_red diffuse_green diffuse_blue"})
    EXPECT_EQ(read(names, "1 1 1", "U U U", {"1 2 3", "4 5 6", "7 8 9", "255 0 1"}).frame.colour.at<cv::Vec3b>(1, 0),
              cv::Vec3b(9, 8, 7));
  EXPECT_EQ(read("b r g", "1 1 1", "U U U", {"1 2 3", "4 5 6", "7 8 9", "255 0 1"}).frame.colour.at<cv::Vec3b>(0, 1),
            cv::Vec3b(4, 6, 5));
}

TEST_F(OtherFields, ColourMayBeFloatsOrSixteenBits) {
  EXPECT_EQ(
      read("r g b", "4 4 4", "F F F", {"1 0 0.2", "0 0 0", "0.4 nan 0", "1 1 1"}).frame.colour.at<cv::Vec3b>(0, 0),
      cv::Vec3b(51, 0, 255));
  EXPECT_EQ(read("r g b", "8 8 8", "F F F", {"255 0 17", "0 0 0", "1 0 0", "9 9 9"}).frame.colour.at<cv::Vec3b>(0, 0),
            cv::Vec3b(17, 0, 255));
  EXPECT_EQ(
      read("r g b", "2 2 2", "U U U", {"65535 0 257", "0 0 0", "1 0 0", "9 9 9"}).frame.colour.at<cv::Vec3b>(0, 0),
      cv::Vec3b(1, 0, 255));
  EXPECT_THROW(read("r g b", "4 4 4", "F F F", {"1e9 0 0", "0 0 0", "0 0 0", "0 0 0"}), InputError);
  EXPECT_THROW(read("r g b", "4 4 4", "F F F", {"-1 0 0", "0 0 0", "0 0 0", "0 0 0"}), InputError);
}

TEST_F(OtherFields, IntensityIsGrey) {
  const cv::Mat colour = read("intensity", "4", "F", {"100", "300", "200", "nan"}).frame.colour;
  EXPECT_EQ(colour.at<cv::Vec3b>(0, 0), cv::Vec3b(0, 0, 0));
  EXPECT_GE(colour.at<cv::Vec3b>(0, 1)[0], 250);
  EXPECT_EQ(colour.at<cv::Vec3b>(1, 1), cv::Vec3b(0, 0, 0));
  EXPECT_EQ(read("intensity rgb", "4 4", "F U", {"1 1", "2 2", "3 3", "4 4"}).frame.colour.at<cv::Vec3b>(0, 1),
            cv::Vec3b(2, 0, 0));
}

TEST_F(OtherFields, LabelsMayBeFloats) {
  const Input input = read("label", "4", "F", {"20", "30.0", "nan", "1"});
  const cv::Mat_<std::uint16_t> expected = (cv::Mat_<std::uint16_t>(2, 2) << 20, 30, 0, 1);
  ASSERT_EQ(input.ground_truth.size(), expected.size()) << input.ground_truth_problem;
  EXPECT_EQ(cv::norm(input.ground_truth, expected, cv::NORM_INF), 0);
}

TEST_F(Pcd, LeavesOutFieldsOfCountZero) {
  const Input input = read_scene(
      write("FIELDS x y _ z\nSIZE 4 4 1 4\nTYPE F F U F\nCOUNT 1 1 0 1\nWIDTH 2\nHEIGHT 2\nPOINTS 4\nDATA ascii\n"
            "0 0 1\n0.5 0 1\n0 0.25 1\n0.5 0.25 1\n"));
  EXPECT_NEAR(input.frame.camera.fx, 2, 1e-6);
  expect_parts(error_of(write("FIELDS x\nSIZE 4\nTYPE F\nCOUNT 0\nWIDTH 2\n")),
               {"c.pcd:4: every field has the count 0"});
}

TEST_F(Pcd, ReadsTheOldVersion) {
  EXPECT_NEAR(read_scene(write_with("VERSION 0.7", "VERSION .5")).frame.camera.fx, 2, 1e-6);
  const Input row = read_scene(write("# .PCD v.5\nVERSION .5\nCOLUMNS x y z\nPOINTS 4\nDATA ascii\n"
                                     "0 0 1\n0.5 0 1\n0 0.25 1\n0.5 0.25 1\n"),
                               Camera{2, 2, 2, 4, 0, 0});
  EXPECT_EQ(row.point_pixels, (std::vector<int>{0, 1, 2, 3}));
}

class Ply : public testing::Test {
 protected:
  /// The four points of a 2x2 image, read with its camera.
  Input read(const std::string& format, const std::string& elements, const std::string& body) const {
    return read_scene(folder_.write("c.ply", "ply\nformat " + format + " 1.0\n" + elements + "end_header\n" + body),
                      Camera{2, 2, 2, 4, 0, 0});
  }

  void expect_four(const Input& input) const {
    EXPECT_EQ(input.point_pixels, (std::vector<int>{0, 1, 2, 3}));
    EXPECT_EQ(input.frame.depth(1, 1), 1.0f);
  }

  const std::string vertices_ = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string rows_ = "0 0 1\n0.5 0 1\n0 0.25 1\n0.5 0.25 1\n";
  TemporaryFolder folder_;
};

TEST_F(Ply, VerticesMayStandInAnyLines) {
  expect_four(read("ascii", vertices_, rows_));
  expect_four(read("ascii", vertices_, "0 0\n1 0.5\n\n0 1 0 0.25 1 0.5\n0.25\r\n1"));
  EXPECT_THROW(read("ascii", vertices_, "0 0 1 0.5 0 1 0 0.25 1 0.5 0.25"), InputError);
}

TEST_F(Ply, ElementsMayStandBeforeTheVertices) {
  const std::string before = "element camera 1\nproperty float f\nproperty list uchar short k\nelement none 2\n";
  expect_four(read("ascii", before + vertices_, "7.5\n2 8 9\n" + rows_));
  std::string points;
  for (const float value : {0.F, 0.F, 1.F, 0.5F, 0.F, 1.F, 0.F, 0.25F, 1.F, 0.5F, 0.25F, 1.F})
    points.append(reinterpret_cast<const char*>(&value), 4);
  expect_four(read("binary_little_endian", before + vertices_, std::string("1234\2abcd", 9) + points));
  EXPECT_THROW(read("binary_little_endian", before + vertices_, std::string("1234\377abcd", 9) + points), InputError);
  EXPECT_THROW(read("ascii", before + vertices_, "7.5\n99999999999999 8 9\n" + rows_), InputError);
  EXPECT_THROW(read("ascii", before + vertices_, "7.5\n-1 8 9\n" + rows_), InputError);
}

TEST_F(Ply, NumbersMayBeBigEndian) {
  std::string points;
  for (const double value : {0., 0., 1., 0.5, 0., 1., 0., 0.25, 1., 0.5, 0.25, 1.}) {
    std::array<char, 8> bytes{};
    std::memcpy(bytes.data(), &value, 8);
    points.append(bytes.rbegin(), bytes.rend());
  }
  const std::string vertices = "element vertex 4\nproperty double x\nproperty double y\nproperty double z\n";
  expect_four(read("binary_big_endian", vertices, points));
  expect_four(read("binary_big_endian", "element a 1\nproperty list ushort uchar b\n" + vertices,
                   std::string("\0\3xyz", 5) + points));
}

TEST_F(Pcd, SkipsPadding) {
  const std::string header =
      "FIELDS _ x y _ z\nSIZE 1 4 4 2 4\nTYPE U F F U F\nCOUNT 3 1 1 1 1\nWIDTH 2\nHEIGHT 2\nPOINTS 4\nDATA ";
  const Input input =
      read_scene(write(header + "ascii\n7 7 7 0 0 7 1\n7 7 7 0.5 0 7 1\n7 7 7 0 0.25 7 1\n7 7 7 0.5 0.25 seven 1\n"));
  EXPECT_NEAR(input.frame.camera.fx, 2, 1e-6);
  EXPECT_NEAR(input.frame.camera.fy, 4, 1e-6);
  expect_parts(error_of(write(header + "binary_compressed\n")), {"c.pcd: has padding fields '_'"});
}

TEST_F(Pcd, RefusesDamagedCompressedData) {
  const fs::path file = folder_.path() / "c.pcd";
  pcl::PCDWriter().writeBinaryCompressed(file.string(),
                                         cloud_of(seen_points(), 8, {{"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}}));
  const std::string whole = test::content(file);
  const std::size_t body = read_pcd_header(file).body;
  const auto with = [&](std::size_t at, char byte) {
    std::string damaged = whole;
    damaged[body + at] = byte;
    return write(damaged);
  };
  expect_parts(error_of(with(3, '\x7f')), {"fewer than it declares", "truncated"});
  expect_parts(error_of(with(4, char(whole[body + 4] + 1))), {"do not match"});
  expect_parts(error_of(with(8, '\xff')), {"damaged compressed data"});
}

TEST_F(Pcd, RefusesWhatIsNoPcd) {
  expect_parts(error_of(write("")), {"c.pcd: is empty"});
  expect_parts(error_of(write("ply\nformat ascii 1.0\n")), {"c.pcd:1: a PCD header has FIELDS here, not 'ply'"});
  expect_parts(error_of(write(std::string(100000, 'x'))), {"c.pcd:0: the PCD header ends here"});
  expect_parts(error_of(folder_.path() / "none.pcd"), {"none.pcd: does not exist"});
}

TEST_F(Pcd, RefusesAnUnorganizedCloudWithoutACamera) {
  const fs::path file = write_with("WIDTH 2\nHEIGHT 2", "WIDTH 4\nHEIGHT 1");
  if (find_camera_file(file)) GTEST_SKIP() << "the temporary folder lies below a camera.yaml";
  expect_parts(error_of(file),
               {"c.pcd: is an unorganized cloud (HEIGHT 1) without a camera", "too few", "give --camera"});
  folder_.write("camera.yaml", "width: 8\nheight: 6\nfx: 10\nfy: 12\ncx: 3.5\ncy: 2.25\n");
  EXPECT_EQ(read_scene(file).frame.width(), 8);
}

TEST_F(Pcd, RefusesAnUnorganizedCloudOfAnotherCamera) {
  const fs::path file = write_with("WIDTH 2\nHEIGHT 2", "WIDTH 4\nHEIGHT 1");
  expect_parts(error_of(file, Camera{2, 2, 5000, 5000, 0, 2}), {"no point lies in the image of the given camera"});
  EXPECT_NE(error_of(file, Camera{8, 6, 0, 1, 1, 1}), "");
  expect_parts(error_of(file, Camera{-8, 6, 1, 1, 1, 1}), {"has no width and height", "give --camera with a file"});
}

TEST_F(Pcd, OfOneRowIsOrganizedForACameraOfItsSize) {
  const fs::path file = write(
      "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 4\nHEIGHT 1\nPOINTS 4\nDATA ascii\n0 0 1\n0.5 0 1\n1 0 1\n1.5 0 "
      "1\n");
  const Input input = read_scene(file, Camera{4, 1, 2, 4, 0, 0});
  EXPECT_TRUE(input.point_pixels.empty());
  EXPECT_EQ(cv::countNonZero(input.frame.depth), 4);
}

TEST_F(Pcd, OfOnePointNeedsACamera) {
  const fs::path file = write("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n0 0 2\n");
  EXPECT_EQ(read_scene(file, Camera{1, 1, 1, 1, 0, 0}).frame.point(0), Eigen::Vector3f(0, 0, 2));
  EXPECT_EQ(read_scene(file, camera_8x6).point_pixels, std::vector<int>{2 * 8 + 4});
}

TEST_F(Pcd, WhosePointsTellNoCameraIsRefused) {
  expect_parts(error_of(write_with("0 0 1\n0.5 0 1\n0 0.25 1\n0.5 0.25 1", "nan nan nan\nnan nan nan\n0 0 -1\n0 0 0")),
               {"c.pcd: no point of the cloud"});
  expect_refusal("0 0 1\n0.5 0 1\n0 0.25 1\n0.5 0.25 1", "1 1 1\n2 2 2\n3 3 3\n4 4 4",
                 {"c.pcd: the points are too few or too similar", "--camera"});
  expect_refusal("0 0 1\n0.5 0 1\n0 0.25 1\n0.5 0.25 1", "0 0 1\n-0.5 0 1\n0 0.25 1\n-0.5 0.25 1",
                 {"c.pcd: no pinhole camera projects", "in the camera's frame"});
  std::vector<Point> scattered = seen_points();
  for (std::size_t i = 0; i < scattered.size(); ++i) std::swap(scattered[i], scattered[(i * 29 + 5) % 48]);
  const fs::path file = folder_.path() / "c.pcd";
  pcl::PCDWriter().writeBinary(file.string(), cloud_of(scattered, 8, {{"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}}));
  expect_parts(error_of(file), {"c.pcd: no pinhole camera projects"});
}

TEST_F(Pcd, RefusesACameraFileThatIsNotItsOwn) {
  const fs::path file = folder_.path() / "c.pcd";
  pcl::PCDWriter().writeBinary(file.string(),
                               cloud_of(seen_points(), 8, {{"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}}));
  folder_.write("camera.yaml", "width: 8\nheight: 6\nfx: 40\nfy: 12\ncx: 3.5\ncy: 2.25\n");
  expect_parts(error_of(file), {"camera.yaml: does not match", "c.pcd", "--camera"});
  folder_.write("camera.yaml", "width: 4\nheight: 6\nfx: 10\nfy: 12\ncx: 3.5\ncy: 2.25\n");
  expect_parts(error_of(file), {"camera.yaml: is for 4x6 images", "c.pcd is 8x6"});
  folder_.write("camera.yaml", "width: 8\nheight: 6\nfx: 10.1\nfy: 12\ncx: 3.5\ncy: 2.25\n");
  EXPECT_DOUBLE_EQ(read_scene(file).frame.camera.fx, 10.1);
}

// The public data set, where it is present.
class Osd : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(osd_ / "pcd/learn0.pcd")) GTEST_SKIP() << osd_ << " is not there";
  }

  const fs::path osd_ = fs::path(GESTALT_SHARED_DATA) / "osd";
};

TEST_F(Osd, CloudEqualsItsSceneFolder) {
  for (const std::string name : {"learn0", "learn20", "learn27", "learn38"}) {
    const Input cloud = read_scene(osd_ / "pcd" / (name + ".pcd")), folder = read_scene(osd_ / "learn" / name);
    EXPECT_LT(cv::norm(cloud.frame.depth, folder.frame.depth, cv::NORM_INF), 1e-6);
    EXPECT_EQ(cv::norm(cloud.ground_truth, folder.ground_truth, cv::NORM_INF), 0);
    EXPECT_EQ(cv::norm(cloud.frame.colour, folder.frame.colour, cv::NORM_INF, folder.frame.depth > 0), 0);
  }
}

TEST_F(Osd, CameraIsFittedToACloudAlone) {
  const TemporaryFolder alone;
  const fs::path file = alone.write("learn0.pcd", test::content(osd_ / "pcd/learn0.pcd"));
  if (find_camera_file(file)) GTEST_SKIP() << "the temporary folder lies below a camera.yaml";
  const Camera c = read_scene(file).frame.camera;
  EXPECT_NEAR(c.fx, 525, 0.01);
  EXPECT_NEAR(c.fy, 525, 0.01);
  EXPECT_NEAR(c.cx, 319.5, 0.01);
  EXPECT_NEAR(c.cy, 239.5, 0.01);
}

TEST_F(Osd, UnorganizedCloudEqualsItsSceneFolder) {
  const Input cloud = read_scene(osd_ / "pcd/learn33_unorganized.pcd"), folder = read_scene(osd_ / "learn/learn33");
  EXPECT_EQ(cloud.point_pixels.size(), 179131u);
  EXPECT_EQ(std::count(cloud.point_pixels.begin(), cloud.point_pixels.end(), -1), 0);
  EXPECT_LT(cv::norm(cloud.frame.depth, folder.frame.depth, cv::NORM_INF), 1e-6);
  EXPECT_EQ(cv::norm(cloud.ground_truth, folder.ground_truth, cv::NORM_INF), 0);
}

}  // namespace
}  // namespace gestalt
