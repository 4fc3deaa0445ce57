// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/input.h"
#include "gestalt/tests/environment/temporary_folder.h"

namespace gestalt {
namespace {

namespace fs = std::filesystem;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
const Camera sensor{80, 60, 70, 70, 39.5, 29.5};

/// What the sensor sees: a wavy wall with a box before it; a corner has no measurement.
std::vector<cv::Vec3f> seen_points() {
  std::vector<cv::Vec3f> points;
  for (int v = 0; v < sensor.height; ++v)
    for (int u = 0; u < sensor.width; ++u) {
      const bool box = u > 30 && u < 50 && v > 20 && v < 40;
      const double z = box ? 1.2 + 0.004 * u : 1.6 + 0.05 * std::sin(0.2 * u) + 0.01 * v;
      if (u < 5 && v < 5)
        points.emplace_back(nan, nan, nan);
      else
        points.emplace_back((u - sensor.cx) / sensor.fx * z, (v - sensor.cy) / sensor.fy * z, z);
    }
  return points;
}

class CloudFrame : public testing::Test {
 protected:
  using Change = std::function<cv::Vec3d(cv::Vec3d)>;

  /// Height 1: unorganized.
  fs::path write(const Change& change, int height = sensor.height,
                 const std::string& viewpoint = "0 0 0 1 0 0 0") const {
    const std::vector<cv::Vec3f> points = seen_points();
    const std::string count = std::to_string(points.size());
    std::string text = "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " +
                       std::to_string(points.size() / std::size_t(height)) + "\nHEIGHT " + std::to_string(height) +
                       "\nVIEWPOINT " + viewpoint + "\nPOINTS " + count + "\nDATA binary\n";
    for (const cv::Vec3f& point : points) {
      const cv::Vec3f moved(change(cv::Vec3d(point)));
      text.append(reinterpret_cast<const char*>(&moved), sizeof moved);
    }
    return folder_.write("c.pcd", text);
  }

  /// The images are those of the sensor, and this describes the change.
  void expect_turned(const Input& input, const std::string& told) const {
    const std::vector<cv::Vec3f> points = seen_points();
    ASSERT_EQ(input.frame.width(), sensor.width);
    ASSERT_EQ(input.frame.height(), sensor.height);
    for (int i = 0; i < int(points.size()); ++i) {
      const cv::Vec3f& p = points[std::size_t(i)];
      ASSERT_EQ(input.frame.valid(i), p[2] > 0);
      if (!(p[2] > 0)) continue;
      ASSERT_LT((input.frame.point(i) - Eigen::Vector3f(p[0], p[1], p[2])).norm(), 1e-3) << i;
    }
    EXPECT_TRUE(std::any_of(input.notes.begin(), input.notes.end(), [&](const std::string& note) {
      return note.find(told) != note.npos;
    })) << told;
  }

  std::string refusal(const fs::path& file, const ReadOptions& options = {}) const {
    try {
      read_scene(file, options);
    } catch (const InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << "not refused";
    return "";
  }

  test::TemporaryFolder folder_;
};

cv::Vec3d same(const cv::Vec3d& p) { return p; }
cv::Vec3d opengl(const cv::Vec3d& p) { return {p[0], -p[1], -p[2]}; }
cv::Vec3d link(const cv::Vec3d& p) { return {p[2], -p[0], -p[1]}; }

/// To a robot's base: the sensor stands 0.8 m above it and looks down by 50 degrees.
cv::Vec3d base(const cv::Vec3d& p) {
  const double c = std::cos(0.87), s = std::sin(0.87);
  const cv::Vec3d q = link(p);
  return {c * q[0] + s * q[2] + 0.3, q[1] - 0.1, -s * q[0] + c * q[2] + 0.8};
}

TEST_F(CloudFrame, OfTheCameraIsLeftAlone) {
  const Input input = read_scene(write(same));
  EXPECT_NEAR(input.frame.camera.fx, 70, 1e-3);
  EXPECT_TRUE(input.notes.empty());
}

TEST_F(CloudFrame, OfAnOrganizedCloudIsRecognised) {
  expect_turned(read_scene(write(opengl)), "OpenGL's frame");
  expect_turned(read_scene(write(link)), "x forward, y left, z up");
  expect_turned(read_scene(write([](const cv::Vec3d& p) { return cv::Vec3d(-p[0], p[1], p[2]); })),
                "a mirrored frame (x left, y down, z forward)");
  expect_turned(read_scene(write(base)), "a frame that is not the camera's");
}

TEST_F(CloudFrame, OfAnOrganizedCloudIsRecognisedByAGivenCamera) {
  expect_turned(read_scene(write(opengl), sensor), "OpenGL's frame");
  expect_turned(read_scene(write(base), sensor), "a frame that is not the camera's");
  Camera numbers = sensor;
  numbers.width = numbers.height = 0;
  EXPECT_TRUE(read_scene(write(same), numbers).notes.empty());
}

TEST_F(CloudFrame, AGivenCameraMustFitThePoints) {
  Camera other = sensor;
  other.fx = other.fy = 120;
  const std::string message = refusal(write(same), other);
  EXPECT_NE(message.find("the given camera: does not match"), message.npos) << message;
  EXPECT_NE(message.find("the points imply focal lengths of 70 and 70 px"), message.npos) << message;
}

TEST_F(CloudFrame, OfAPlaneIsToldByTheViewpoint) {
  // Of a plane alone the projection cannot be solved; w, x, y, z of a turn by 0.4 about y.
  const double a = 0.4, c = std::cos(a), s = std::sin(a);
  std::string text = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 20\nHEIGHT 15\nVIEWPOINT 1 2 3 " +
                     std::to_string(std::cos(a / 2)) + " 0 " + std::to_string(std::sin(a / 2)) +
                     " 0\nPOINTS 300\nDATA ascii\n";
  for (int v = 0; v < 15; ++v)
    for (int u = 0; u < 20; ++u) {
      const double x = (u - 9.5) / 25, y = (v - 7) / 25.0, z = 1;
      text += std::to_string(c * x + s * z + 1) + ' ' + std::to_string(y + 2) + ' ' +
              std::to_string(-s * x + c * z + 3) + '\n';
    }
  const Input input = read_scene(folder_.write("plane.pcd", text));
  EXPECT_NEAR(input.frame.camera.fx, 25, 0.01);
  EXPECT_NEAR(input.frame.depth(7, 10), 1, 1e-3);
  ASSERT_EQ(input.notes.size(), 1U);
  EXPECT_NE(input.notes[0].find("VIEWPOINT"), std::string::npos);
}

TEST_F(CloudFrame, OfAnUnorganizedCloudIsRecognisedByItsCamera) {
  expect_turned(read_scene(write(opengl, 1), sensor), "OpenGL's frame");
  expect_turned(read_scene(write(link, 1), sensor), "x forward, y left, z up");
  EXPECT_TRUE(read_scene(write(same, 1), sensor).notes.empty());
}

TEST_F(CloudFrame, MostPointsMustLieInTheImage) {
  const auto shifted = [](double x) {
    return [x](const cv::Vec3d& p) { return cv::Vec3d(p[0] + x * p[2], p[1], p[2]); };
  };
  const std::string message = refusal(write(shifted(0.7), 1), sensor);  // by 49 of 80 pixels
  EXPECT_NE(message.find("% of the points lie in the image of the given camera"), message.npos) << message;
  const Input input = read_scene(write(shifted(0.3), 1), sensor);
  EXPECT_TRUE(std::any_of(input.warnings.begin(), input.warnings.end(), [](const std::string& warning) {
    return warning.find("of its points lie outside") != warning.npos;
  }));
}

TEST_F(CloudFrame, AVirtualCameraIsAsDenseAsThePoints) {
  for (const Change& frame : {Change(same), Change(opengl), Change(link)}) {
    const Input input = read_scene(write(frame, 1));
    EXPECT_NEAR(input.frame.camera.fx, 70, 20);
    EXPECT_GT(cv::countNonZero(input.frame.depth), 0.8 * double(input.frame.depth.total()));
    EXPECT_TRUE(std::any_of(input.notes.begin(), input.notes.end(), [](const std::string& note) {
      return note.find("no camera is given for an unorganized cloud; a virtual one") != note.npos;
    }));
  }
}

// The origin lies among the points.
TEST_F(CloudFrame, AnotherFrameIsNoPlaceForAVirtualCamera) {
  const std::string message = refusal(write([](const cv::Vec3d& p) { return p - cv::Vec3d(0, 0, 1.5); }, 1));
  EXPECT_NE(message.find("do not lie in the field of view"), message.npos) << message;
}

TEST_F(CloudFrame, PixelsThatAreMuchFinerThanThePointsAreJoined) {
  const Input input = read_scene(write(same, 1), Camera{800, 600, 700, 700, 399.5, 299.5});
  EXPECT_LT(input.frame.width(), 120);
  EXPECT_GT(input.frame.width(), 50);
  EXPECT_NEAR(input.frame.camera.fx / input.frame.width(), 700.0 / 800, 0.02);
  EXPECT_TRUE(std::any_of(input.notes.begin(), input.notes.end(), [](const std::string& note) {
    return note.find("much finer than the points") != note.npos;
  }));
}

}  // namespace
}  // namespace gestalt
