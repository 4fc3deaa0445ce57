// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/bag/bag_frames.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string>

#include "gestalt/core/base/error.h"
#include "gestalt/tests/environment/temporary_folder.h"

namespace gestalt {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

/// Little-endian.
template <class Number>
std::string bytes_of(Number value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}
std::string text_of(const std::string& text) { return bytes_of(std::uint32_t(text.size())) + text; }

std::string header(double seconds) {
  const auto whole = std::uint32_t(seconds);
  return bytes_of(std::uint32_t{0}) + bytes_of(whole) + bytes_of(std::uint32_t((seconds - whole) * 1e9)) +
         text_of("cam");
}

std::string image(double seconds, int width, int height, const std::string& encoding, const std::string& pixels,
                  bool big_endian = false) {
  return header(seconds) + bytes_of(std::uint32_t(height)) + bytes_of(std::uint32_t(width)) + text_of(encoding) +
         std::string(1, char(big_endian)) + bytes_of(std::uint32_t(pixels.size() / std::size_t(height))) +
         text_of(pixels);
}

std::string depth_image(double seconds, std::uint16_t millimetres = 800) {
  std::string pixels;
  for (int i = 0; i < 12; ++i) pixels += bytes_of(millimetres);
  return image(seconds, 4, 3, "16UC1", pixels);
}

std::string rgb_image(double seconds) {
  std::string pixels;
  for (int i = 0; i < 12; ++i) pixels += {'\x0a', '\x14', '\x1e'};
  return image(seconds, 4, 3, "rgb8", pixels);
}

std::string camera_info(double fx = 4, int width = 4, int height = 3) {
  std::string info = header(1) + bytes_of(std::uint32_t(height)) + bytes_of(std::uint32_t(width)) +
                     text_of("plumb_bob") + bytes_of(std::uint32_t{0});
  const double k[] = {fx, 0, width / 2.0, 0, fx, height / 2.0, 0, 0, 1};
  for (const double x : k) info += bytes_of(x);
  for (int i = 0; i < 9 + 12; ++i) info += bytes_of(0.0);
  return info + std::string(4 * 6 + 1, '\0');
}

/// A bag of ROS 1 in the making.
class Writer {
 public:
  void put(const std::string& topic, const std::string& type, const std::string& message) {
    const auto number = std::uint32_t(connections_.size());
    const auto [known, is_new] = connections_.try_emplace(topic, number);
    if (is_new)
      chunk_ += record(field("op", "\x07") + field("conn", bytes_of(number)) + field("topic", topic),
                       field("topic", topic) + field("type", type));
    chunk_ += record(field("op", "\x02") + field("conn", bytes_of(known->second)) + field("time", std::string(8, '\0')),
                     message);
  }
  void depth(const std::string& message, const std::string& topic = "/depth/image_raw") {
    put(topic, "sensor_msgs/Image", message);
  }
  void colour(const std::string& message) { put("/rgb/image_raw", "sensor_msgs/Image", message); }
  void info(const std::string& message, const std::string& topic = "/depth/camera_info") {
    put(topic, "sensor_msgs/CameraInfo", message);
  }

  std::string bag(const std::string& compression = "none") const {
    return "#ROSBAG V2.0\n" +
           record(field("op", "\x03") + field("index_pos", std::string(8, '\0')), std::string(64, ' ')) +
           record(field("op", "\x05") + field("compression", compression) +
                      field("size", bytes_of(std::uint32_t(chunk_.size()))),
                  chunk_);
  }

 private:
  static std::string field(const std::string& name, const std::string& value) { return text_of(name + "=" + value); }
  static std::string record(const std::string& fields, const std::string& data) {
    return text_of(fields) + text_of(data);
  }

  std::map<std::string, std::uint32_t> connections_;
  std::string chunk_;
};

class BagFramesTest : public testing::Test {
 protected:
  BagFrames frames(const std::string& bytes, const BagTopics& topics = {}) const {
    return BagFrames(folder_.write("r.bag", bytes), topics);
  }
  BagFrames frames() const { return frames(writer_.bag()); }

  template <class Work>
  static std::string error_of(const Work& work) {
    try {
      work();
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  std::string error() const {
    return error_of([&] { frames(); });
  }
  std::string error_of_frame() const {
    const BagFrames made = frames();
    return error_of([&] { made.read(made.frames().front()); });
  }
  static void expect(const std::string& text, const std::vector<std::string>& parts) {
    for (const std::string& part : parts) EXPECT_NE(text.find(part), text.npos) << part << "\nin: " << text;
  }

  TemporaryFolder folder_;
  Writer writer_;
};

TEST_F(BagFramesTest, ADepthImageGoesWithTheNearestColour) {
  writer_.info(camera_info());
  for (const double t : {1.0, 1.1, 1.5}) writer_.depth(depth_image(t));
  for (const double t : {1.02, 1.11, 1.09, 1.7}) writer_.colour(rgb_image(t));
  const BagFrames made = frames();
  ASSERT_EQ(made.frames().size(), 2u);
  EXPECT_EQ(made.frames()[0].name, "1.000000000");
  expect(made.notes().back(), {"1 of 3 depth images are left out", "0.03 s"});
  const ConvertedScene scene = made.read(made.frames()[0]);
  EXPECT_EQ(scene.images.depth(2, 3), 800);
  EXPECT_EQ(scene.images.colour.at<cv::Vec3b>(1, 1), cv::Vec3b(30, 20, 10));
  EXPECT_EQ(scene.camera.fx, 4);
  EXPECT_EQ(scene.camera.cx, 2);
}

TEST_F(BagFramesTest, DepthAloneIsAFrameToo) {
  writer_.info(camera_info());
  writer_.depth(depth_image(1));
  writer_.depth(depth_image(1));
  const BagFrames made = frames();
  ASSERT_EQ(made.frames().size(), 1u);
  expect(made.notes().back(), {"1 of 2 depth images are left out", "the one before"});
  EXPECT_TRUE(made.read(made.frames()[0]).images.colour.empty());
}

TEST_F(BagFramesTest, RegisteredDepthIsPreferredAndSeveralAreRefused) {
  writer_.depth(depth_image(1), "/depth/image_raw");
  writer_.depth(depth_image(1), "/depth_registered/image_raw");
  expect(frames().notes().front(), {"depth of /depth_registered/image_raw"});
  writer_.depth(depth_image(1), "/other/depth_registered/image_raw");
  expect(error(), {"several topics may be depth", "/depth_registered/image_raw, /other/", "--depth-topic"});
  EXPECT_EQ(frames(writer_.bag(), {"/depth/image_raw", ""}).frames().size(), 1u);
}

TEST_F(BagFramesTest, WithoutDepthTheTopicsAreNamed) {
  writer_.colour(rgb_image(1));
  expect(error(), {"r.bag: has no topic of depth images", "/rgb/image_raw (sensor_msgs/Image, 1)"});
}

TEST_F(BagFramesTest, ClocksThatDifferAndNoStampsAreRefused) {
  writer_.depth(depth_image(1));
  writer_.colour(rgb_image(5));
  expect(error(), {"within 0.03 s", "clocks"});
  writer_ = {};
  writer_.depth(depth_image(0));
  expect(error(), {"no time stamps"});
}

TEST_F(BagFramesTest, WithoutCameraInfoACameraIsNeeded) {
  writer_.depth(depth_image(1));
  expect(error_of_frame(), {"r.bag: 1.000000000: ", "no camera_info beside /depth/image_raw", "--camera"});
}

TEST_F(BagFramesTest, CamerasThatChangeOrAreTwoAreWarnedOf) {
  writer_.info(camera_info(4));
  writer_.info(camera_info(5));
  writer_.info(camera_info(6), "/rgb/camera_info");
  writer_.depth(depth_image(1));
  writer_.colour(rgb_image(1));
  const BagFrames made = frames();
  ASSERT_EQ(made.warnings().size(), 2u);
  expect(made.warnings()[0], {"/depth/camera_info changes"});
  expect(made.warnings()[1], {"different cameras", "--depth-topic"});
}

TEST_F(BagFramesTest, EncodingsThatCannotBeReadAreNamed) {
  writer_.info(camera_info());
  writer_.depth(image(1, 4, 3, "8UC1", std::string(12, 'x')));
  expect(error_of_frame(), {"encoding '8UC1'", "16UC1 or 32FC1"});
  writer_ = {};
  writer_.info(camera_info());
  writer_.depth(depth_image(1));
  writer_.colour(image(1, 4, 3, "float99", std::string(12, 'x')));
  expect(error_of_frame(), {"encoding 'float99'", "bgr8", "bayer_rggb8"});
}

TEST_F(BagFramesTest, BigEndianFloatsAndPaddedRowsAreRead) {
  writer_.info(camera_info());
  std::string pixels;
  for (int row = 0; row < 3; ++row) {
    for (int i = 0; i < 4; ++i) pixels += {'\x3f', '\x40', '\0', '\0'};  // 0.75
    pixels += std::string(8, 'p');
  }
  writer_.depth(image(1, 4, 3, "32FC1", pixels, true));
  const BagFrames made = frames();
  EXPECT_EQ(made.read(made.frames()[0]).images.depth(2, 3), 750);
}

TEST_F(BagFramesTest, ImagesThatLieAboutTheirSizeAreRefused) {
  writer_.info(camera_info());
  writer_.depth(image(1, 4, 3000, "16UC1", std::string(24000, 'x')));
  std::string lying = depth_image(2);
  lying[19] = '\x7f';  // height
  writer_.depth(lying);
  const BagFrames made = frames();
  expect(error_of([&] { made.read(made.frames()[1]); }), {"2.000000000", "pixels"});
}

TEST_F(BagFramesTest, ARecordingThatBreaksOffIsReadAsFarAsItGoes) {
  writer_.info(camera_info());
  writer_.depth(depth_image(1));
  const std::string whole = writer_.bag();
  const BagFrames made = frames(whole + whole.substr(200, 60));
  EXPECT_EQ(made.frames().size(), 1u);
  ASSERT_EQ(made.warnings().size(), 1u);
  expect(made.warnings()[0], {"breaks off", "incomplete"});
}

TEST_F(BagFramesTest, WhereverABagIsCutItIsReadOrRefused) {
  writer_.info(camera_info());
  writer_.depth(depth_image(1));
  writer_.colour(rgb_image(1));
  const std::string whole = writer_.bag();
  for (std::size_t size = 0; size < whole.size(); size += 7)
    EXPECT_NE(error_of([&] { frames(whole.substr(0, size)); }), "no error") << size;
}

TEST_F(BagFramesTest, AnUnknownCompressionIsNamed) {
  writer_.depth(depth_image(1));
  expect(error_of([&] { frames(writer_.bag("xz")); }), {"compression 'xz'", "none, bz2, lz4 and zstd"});
  expect(error_of([&] { frames(writer_.bag("lz4")); }), {"r.bag: byte ", "lz4 data are damaged"});
}

TEST_F(BagFramesTest, OtherFilesAreNotRecordings) {
  expect(error_of([&] { frames("#ROSBAG V1.2\n and more bytes"); }), {"rosbag fix"});
  expect(error_of([&] { frames("width: 3\nheight: 4\nfx: 2\n"); }), {"is not a recording of ROS"});
  EXPECT_FALSE(is_bag(folder_.write("c.yaml", "width: 3\nheight: 4\n")));
  EXPECT_FALSE(is_bag(folder_.path()));
}

}  // namespace
}  // namespace gestalt
