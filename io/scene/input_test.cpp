// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/input.h"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "gestalt/core/base/error.h"
#include "gestalt/tests/environment/decimal_comma.h"
#include "gestalt/tests/environment/temporary_folder.h"

namespace gestalt {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

const std::string camera_4x3 = "width: 4\nheight: 3\nfx: 2\nfy: 2.5\ncx: 1.5\ncy: 1\n";

std::string png(const cv::Mat& image) {
  std::vector<unsigned char> bytes;
  cv::imencode(".png", image, bytes);
  return {bytes.begin(), bytes.end()};
}

cv::Mat_<std::uint16_t> depth_4x3() {
  return (cv::Mat_<std::uint16_t>(3, 4) << 0, 1000, 1001, 1002, 857, 0, 65534, 1, 900, 901, 902, 903);
}

/// What reading throws, and what stderr shows meanwhile must be nothing.
template <class Read>
std::string error_of(const Read& read) {
  testing::internal::CaptureStderr();
  std::string message;
  try {
    read();
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

class SceneFolder : public testing::Test {
 protected:
  SceneFolder() {
    folder_.write("s/depth.png", png(depth_4x3()));
    folder_.write("s/camera.yaml", camera_4x3);
  }

  fs::path scene() const { return folder_.path() / "s"; }
  void expect_refusal(const std::vector<std::string>& parts) const {
    expect_parts(error_of([&] { read_scene(scene()); }), parts);
  }

  TemporaryFolder folder_;
};

TEST_F(SceneFolder, GivesDepthInMetresAndPointsInTheCameraFrame) {
  const Input input = read_scene(scene());
  EXPECT_EQ(input.path, scene());
  EXPECT_EQ(input.frame.name, "s");
  EXPECT_FALSE(input.frame.has_colour());
  EXPECT_TRUE(input.ground_truth.empty());
  EXPECT_TRUE(input.point_pixels.empty());
  EXPECT_EQ(input.frame.depth(0, 0), 0.0f);
  EXPECT_EQ(input.frame.depth(1, 0), 0.857f);
  EXPECT_EQ(input.frame.depth(1, 2), 65.534f);
  const Eigen::Vector3f p = input.frame.point(2 * 4 + 3);  // (3 - 1.5) / 2 * 0.903, (2 - 1) / 2.5 * 0.903
  EXPECT_NEAR(p.x(), 0.67725f, 1e-6f);
  EXPECT_NEAR(p.y(), 0.3612f, 1e-6f);
  EXPECT_EQ(p.z(), 0.903f);
}

TEST_F(SceneFolder, UsesTheDepthScale) {
  folder_.write("s/camera.yaml", camera_4x3 + "depth_scale: 0.0002\n");
  EXPECT_FLOAT_EQ(read_scene(scene()).frame.depth(0, 1), 0.2f);
}

TEST_F(SceneFolder, TakesAnyEightBitColour) {
  const cv::Mat grey(3, 4, CV_8UC1, cv::Scalar(7)), bgr(3, 4, CV_8UC3, cv::Scalar(1, 2, 3)),
      bgra(3, 4, CV_8UC4, cv::Scalar(4, 5, 6, 0));
  folder_.write("s/rgb.png", png(grey));
  EXPECT_EQ(read_scene(scene()).frame.colour.at<cv::Vec3b>(2, 3), cv::Vec3b(7, 7, 7));
  folder_.write("s/rgb.png", png(bgr));
  EXPECT_EQ(read_scene(scene()).frame.colour.at<cv::Vec3b>(2, 3), cv::Vec3b(1, 2, 3));
  folder_.write("s/rgb.png", png(bgra));
  const Input input = read_scene(scene());
  EXPECT_EQ(input.frame.colour.type(), CV_8UC3);
  EXPECT_EQ(input.frame.colour.at<cv::Vec3b>(2, 3), cv::Vec3b(4, 5, 6));
}

// Two colours take one bit a pixel.
TEST_F(SceneFolder, TakesColoursOfAPalette) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = 4;
  image.height = 3;
  image.format = PNG_FORMAT_RGB_COLORMAP;
  image.colormap_entries = 2;
  const std::array<uchar, 12> indices{0, 1, 0, 1, 1, 0, 1, 0, 0, 0, 0, 1};
  const std::array<uchar, 6> colours{10, 20, 30, 40, 50, 60};
  ASSERT_TRUE(png_image_write_to_file(&image, (scene() / "rgb.png").c_str(), 0, indices.data(), 0, colours.data()));
  const cv::Mat colour = read_scene(scene()).frame.colour;
  EXPECT_EQ(colour.at<cv::Vec3b>(0, 0), cv::Vec3b(30, 20, 10));
  EXPECT_EQ(colour.at<cv::Vec3b>(2, 3), cv::Vec3b(60, 50, 40));
}

TEST_F(SceneFolder, TakesLabelsOfEightAndSixteenBits) {
  folder_.write("s/label.png", png(cv::Mat(3, 4, CV_8UC1, cv::Scalar(21))));
  EXPECT_EQ(read_scene(scene()).ground_truth(0, 0), 21);
  folder_.write("s/label.png", png(cv::Mat(3, 4, CV_16UC1, cv::Scalar(2100))));
  EXPECT_EQ(read_scene(scene()).ground_truth(2, 3), 2100);
}

TEST_F(SceneFolder, TakesTheNearestCameraOfItsParents) {
  folder_.write("camera.yaml", "width: 1\nheight: 1\nfx: 1\nfy: 1\ncx: 0\ncy: 0\n");
  EXPECT_DOUBLE_EQ(read_scene(scene()).frame.camera.fy, 2.5);
  fs::remove(scene() / "camera.yaml");
  folder_.write("camera.yaml", camera_4x3 + "depth_scale: 0.002\n");
  EXPECT_EQ(find_camera_file(scene() / ""), folder_.path() / "camera.yaml");
  EXPECT_FLOAT_EQ(read_scene(scene()).frame.depth(0, 1), 2.0f);
}

TEST_F(SceneFolder, PrefersTheGivenCamera) {
  CameraFile camera(Camera{4, 3, 10, 20, 2, 1});
  camera.depth_scale = 0.01;
  const Input input = read_scene(scene(), camera);
  EXPECT_DOUBLE_EQ(input.frame.camera.fx, 10);
  EXPECT_FLOAT_EQ(input.frame.depth(0, 1), 10.0f);
  EXPECT_DOUBLE_EQ(read_scene(scene(), Camera{4, 3, 11, 20, 2, 1}).frame.camera.fx, 11);
}

TEST_F(SceneFolder, WarnsOfPixelsThatNoSensorHas) {
  EXPECT_TRUE(read_scene(scene()).warnings.empty());
  folder_.write("s/camera.yaml", "width: 4\nheight: 3\nfx: 500\nfy: 50\ncx: 1.5\ncy: 1\n");
  const std::vector<std::string> warnings = read_scene(scene()).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  expect_parts(warnings[0], {"s: ", "fx 500 and fy 50", "10 times as high as wide", "check both"});
}

TEST_F(SceneFolder, MayBeOnePixel) {
  folder_.write("s/depth.png", png(cv::Mat(1, 1, CV_16UC1, cv::Scalar(500))));
  folder_.write("s/camera.yaml", "width: 1\nheight: 1\nfx: 525\nfy: 525\ncx: 0\ncy: 0\n");
  const Input input = read_scene(scene());
  EXPECT_EQ(input.frame.width(), 1);
  EXPECT_EQ(input.frame.point(0), Eigen::Vector3f(0, 0, 0.5f));
}

TEST_F(SceneFolder, IsRefusedWithoutDepth) {
  fs::remove(scene() / "depth.png");
  expect_refusal({"s: camera.yaml is there, but no depth image", "depth.png", "16-bit grey"});
  fs::create_directory(scene() / "depth.png");
  expect_refusal({"s/depth.png: is a folder"});
}

TEST_F(SceneFolder, IsRefusedWhenDepthIsEmptyOrNoPng) {
  folder_.write("s/depth.png", "");
  expect_refusal({"depth.png: is empty"});
  folder_.write("s/depth.png", "II* a float TIFF");
  expect_refusal({"depth.png: is not an image that can be read", "save it as PNG"});
}

TEST_F(SceneFolder, IsRefusedWhereverAPngIsCut) {
  const std::string whole = png(depth_4x3());
  for (std::size_t size = 1; size < whole.size(); ++size) {
    folder_.write("s/depth.png", whole.substr(0, size));
    expect_refusal(
        {size < 8 ? "depth.png: is not an image that can be read" : "depth.png: is truncated or damaged at byte"});
  }
}

TEST_F(SceneFolder, IsRefusedWhenAByteOfAPngIsWrong) {
  const std::string whole = png(depth_4x3());
  for (std::size_t i = 8; i < whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i] = char(damaged[i] ^ 0x10);
    folder_.write("s/depth.png", damaged);
    expect_refusal({"depth.png: "});
  }
}

TEST_F(SceneFolder, IsRefusedWhenPixelDataAreWrongUnderRightChecksums) {
  // The pixel data of another size: the stream ends before the last row, or rows do not end where they should.
  for (const cv::Size declared : {cv::Size(4, 4), cv::Size(5, 3), cv::Size(400, 300)}) {
    const std::string whole = png(depth_4x3()), other = png(cv::Mat::ones(declared, CV_16UC1));
    folder_.write("s/depth.png", other.substr(0, 33) + whole.substr(33));  // signature and IHDR are 33 bytes
    testing::internal::CaptureStderr();  // only here the decoder itself finds the fault, and says so
    EXPECT_THROW(read_scene(scene()), InputError);
    testing::internal::GetCapturedStderr();
  }
}

TEST_F(SceneFolder, IsRefusedForOtherKindsOfDepth) {
  folder_.write("s/depth.png", png(cv::Mat(3, 4, CV_8UC1, cv::Scalar(9))));
  expect_refusal({"depth.png: is 8-bit grey", "uint16", "depth_scale"});
  folder_.write("s/depth.png", png(cv::Mat(3, 4, CV_8UC3, cv::Scalar(9))));
  expect_refusal({"depth.png: is 8-bit RGB", "uint16"});
  folder_.write("s/depth.png", png(cv::Mat(3, 4, CV_16UC3, cv::Scalar(9))));
  expect_refusal({"depth.png: is 16-bit RGB"});
}

TEST_F(SceneFolder, TakesSixteenBitColour) {
  folder_.write("s/rgb.png", png(cv::Mat(3, 4, CV_16UC3, cv::Scalar(257, 514, 65535))));
  EXPECT_EQ(read_scene(scene()).frame.colour.at<cv::Vec3b>(2, 3), cv::Vec3b(1, 2, 255));
  folder_.write("s/rgb.png", png(cv::Mat(3, 4, CV_16UC3, cv::Scalar(1, 2, 255))));  // of 8 bits, stored in 16
  EXPECT_EQ(read_scene(scene()).frame.colour.at<cv::Vec3b>(2, 3), cv::Vec3b(1, 2, 255));
}

TEST_F(SceneFolder, IsReadWhateverItsLabelsAre) {
  folder_.write("s/label.png", png(cv::Mat(3, 4, CV_8UC3, cv::Scalar(9, 9, 9))));
  EXPECT_EQ(read_scene(scene()).ground_truth(2, 3), 9);
  folder_.write("s/label.png", png(cv::Mat(1, 1, CV_8UC1, cv::Scalar(9))));
  const Input input = read_scene(scene());
  EXPECT_TRUE(input.ground_truth.empty());
  expect_parts(input.ground_truth_problem, {"label.png: is 1x1, depth is 4x3"});
  EXPECT_EQ(input.warnings.size(), 1U);
}

TEST_F(SceneFolder, TakesTheUnitThatIsTold) {
  EXPECT_EQ(read_scene(scene()).depth_unit, "0.001 m, the default for whole numbers");
  folder_.write("s/camera.yaml", camera_4x3 + "depth_scale: 0.0002\n");
  EXPECT_FLOAT_EQ(read_scene(scene()).frame.depth(0, 1), 0.2F);
  ReadOptions options;
  options.depth_scale = 0.0001;
  EXPECT_FLOAT_EQ(read_scene(scene(), options).frame.depth(0, 1), 0.1F);
  EXPECT_EQ(read_scene(scene(), options).depth_unit, "0.0001 m, as given");
}

TEST_F(SceneFolder, TakesTheLargestNumberForNoMeasurement) {
  cv::Mat_<std::uint16_t> depth = depth_4x3();
  depth(0, 1) = 65535;
  folder_.write("s/depth.png", png(depth));
  EXPECT_EQ(read_scene(scene()).frame.depth(0, 1), 0);
}

TEST_F(SceneFolder, TurnsBitsBackAndDividesByRays) {
  folder_.write("s/depth.png", png(cv::Mat_<std::uint16_t>(3, 4, std::uint16_t(8000))));
  ReadOptions options;
  options.depth_kind = DepthKind::rotated;
  EXPECT_FLOAT_EQ(read_scene(scene(), options).frame.depth(2, 3), 1);
  options.depth_kind = DepthKind::radial;
  EXPECT_FLOAT_EQ(read_scene(scene(), options).frame.depth(1, 3), float(8 / std::hypot(1.5 / 2, 1)));
}

TEST_F(SceneFolder, IsRefusedWhenSizesDiffer) {
  folder_.write("s/rgb.png", png(cv::Mat(4, 3, CV_8UC3, cv::Scalar(9))));
  expect_refusal({"rgb.png: is 3x4, depth.png is 4x3", "register"});
  fs::remove(scene() / "rgb.png");
  folder_.write("s/camera.yaml", "width: 640\nheight: 480\nfx: 525\nfy: 525\ncx: 319.5\ncy: 239.5\n");
  expect_refusal({"camera.yaml: is for 640x480 images", "depth.png is 4x3", "give the camera file"});
  expect_parts(error_of([&] { read_scene(scene(), Camera{1, 1, 1, 1, 0, 0}); }), {"the given camera: is for 1x1"});
}

TEST_F(SceneFolder, IsRefusedWhenNoPixelHasDepth) {
  folder_.write("s/depth.png", png(cv::Mat::zeros(3, 4, CV_16UC1)));
  expect_refusal({"depth.png: no pixel has a measurement"});
}

TEST_F(SceneFolder, IsRefusedWithoutACamera) {
  fs::remove(scene() / "camera.yaml");
  if (find_camera_file(scene())) GTEST_SKIP() << "the temporary folder lies below a camera.yaml";
  expect_refusal({"s/depth.png: has no camera (depth.png is in", "--camera"});
}

TEST_F(SceneFolder, IsRefusedBeforeDecodingWhenItDeclaresTooManyPixels) {
  std::string bomb = png(depth_4x3());
  bomb.replace(16, 8, std::string("\0\0\x40\0\0\0\x40\0", 8));  // 16384 x 16384, below with the checksum of that
  bomb.replace(29, 4, std::string("\xdc\x33\x93\x1b", 4));
  folder_.write("s/depth.png", bomb);
  expect_refusal({"depth.png: declares 16384x16384 pixels", "2^26"});
  bomb.replace(16, 8, std::string("\0\0\x20\0\0\0\x20\0", 8));  // 8192 x 8192
  bomb.replace(29, 4, std::string("\x07\x51\x49\xc6", 4));
  folder_.write("s/depth.png", bomb);
  expect_refusal({"depth.png: declares 8192x8192 pixels", "more than its", "bytes can hold"});
}

class CameraYaml : public testing::Test {
 protected:
  std::string refusal(const std::string& text) const {
    const fs::path file = folder_.write("camera.yaml", text);
    std::string message = error_of([&] { read_camera(file); });
    for (std::size_t at; (at = message.find(file.string())) != message.npos;)
      message.replace(at, file.string().size(), "F");
    return message;
  }

  TemporaryFolder folder_;
};

TEST_F(CameraYaml, GivesAllValues) {
  const CameraFile c = read_camera(folder_.write(
      "c.yaml",
      "# Kinect\nwidth: 640\nheight: 480\nfx: 525.5\nfy: 5.25e2\ncx: 319.5\ncy: 239.25\ndepth_scale: 0.0001\n"));
  EXPECT_EQ(c.camera.width, 640);
  EXPECT_EQ(c.camera.height, 480);
  EXPECT_DOUBLE_EQ(c.camera.fx, 525.5);
  EXPECT_DOUBLE_EQ(c.camera.fy, 525);
  EXPECT_DOUBLE_EQ(c.camera.cx, 319.5);
  EXPECT_DOUBLE_EQ(c.camera.cy, 239.25);
  EXPECT_DOUBLE_EQ(c.depth_scale.value(), 0.0001);
  EXPECT_EQ(c.file, folder_.path() / "c.yaml");
}

TEST_F(CameraYaml, ReadsTheSameUnderADecimalComma) {
  const test::DecimalComma comma;
  const CameraFile c = read_camera(folder_.write("c.yaml", camera_4x3));
  EXPECT_DOUBLE_EQ(c.camera.fy, 2.5);
  EXPECT_NE(refusal("width: 4\nheight: 3\nfx: -1\n").find("from 0.01 to 1e+07"), std::string::npos);
}

TEST_F(CameraYaml, IsRefusedForMissingKeys) {
  EXPECT_EQ(refusal("width: 4\nheight: 3\nfx: 2\ncx: 1\ncy: 1\n"),
            "F:1:1: 'fy' is missing: focal length in pixel heights");
  EXPECT_NE(refusal("fx:\n").find("F:1:1: fx has no number"), std::string::npos);
}

TEST_F(CameraYaml, IsRefusedForUnknownAndRepeatedKeys) {
  EXPECT_EQ(refusal(camera_4x3 + "depht_scale: 0.001\n"),
            "F:7:1: unknown key 'depht_scale'; did you mean 'depth_scale'?");
  EXPECT_EQ(refusal(camera_4x3 + "fx: 3\n"), "F:7:1: 'fx' appears twice; keep one");
}

TEST_F(CameraYaml, IsRefusedForIntrinsicsThatAreNoPositiveNumbers) {
  for (const std::string value : {"0", "-525", "nan", ".nan", "inf", "1e999", "5,250", "abc", "''", "[525]", "1e300"}) {
    const std::string text = "width: 4\nheight: 3\nfx:  " + value + "\nfy: 2\ncx: 1\ncy: 1\n";
    const std::string message = refusal(text);
    EXPECT_EQ(message.find(value == "[525]" ? "F:3:1: fx" : "F:3:6: fx is "), 0u) << message;
    EXPECT_NE(message.find("focal length"), message.npos) << message;
  }
}

TEST_F(CameraYaml, IsRefusedForAPrincipalPointOutsideTheImage) {
  expect_parts(refusal("width: 4\nheight: 3\nfx: 2\nfy: 2\ncx: 4.5\ncy: -1\n"),
               {"F:5:5: cx is '4.5'", "from 0 to 4", "\nF:6:5: cy is '-1'", "from 0 to 3"});
}

TEST_F(CameraYaml, IsRefusedForSizesThatAreNoWholePositiveNumbers) {
  for (const std::string value : {"0", "-4", "4.5", "0x10", "99999999999"})
    EXPECT_EQ(refusal("width: " + value + "\nheight: 3\nfx: 2\nfy: 2\ncx: 1\ncy: 1\n").find("F:1:8: width is "), 0u);
  expect_parts(refusal("width: 1000000\nheight: 1000000\nfx: 2\nfy: 2\ncx: 1\ncy: 1\n"), {"F:1:1: ", "2^26"});
}

TEST_F(CameraYaml, IsRefusedForADepthScaleThatIsNoScale) {
  expect_parts(refusal(camera_4x3 + "depth_scale: 1000\n"), {"F:7:14: depth_scale is '1000'", "metres per unit"});
  expect_parts(refusal(camera_4x3 + "depth_scale: 0\n"), {"F:7:14: depth_scale is '0'"});
}

TEST_F(CameraYaml, ReportsAllErrorsTogether) {
  const std::string message = refusal("width: 0\nheight: x\nfoo: 1\n");
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 6);
}

TEST_F(CameraYaml, IsRefusedWhenItIsNoMapOrNoYaml) {
  EXPECT_EQ(refusal("just words\n").find("F:1:1: is not a camera file"), 0u);
  EXPECT_EQ(refusal("# nothing\n").find("F:1:1: is not a camera file"), 0u);
  EXPECT_EQ(refusal("width: 4\nfx: [1, 2\nfy: }\n").find("F:3:"), 0u);
  EXPECT_EQ(refusal(std::string(100000, '[')).find("F: has 100000 bytes"), 0u);
  EXPECT_EQ(refusal(std::string(60000, '[')).find("F:1:"), 0u);
  EXPECT_EQ(refusal("").find("F: is empty"), 0u);
  expect_parts(error_of([&] { read_camera(folder_.path() / "none.yaml"); }), {"none.yaml: does not exist"});
  expect_parts(error_of([&] { read_camera(folder_.path()); }), {": is a folder"});
}

class FindScenes : public testing::Test {
 protected:
  std::vector<std::string> names(const std::vector<fs::path>& paths) const {
    std::vector<std::string> result;
    for (const fs::path& scene : find_scenes(paths))
      result.push_back(scene.lexically_relative(folder_.path()).string());
    return result;
  }

  TemporaryFolder folder_;
};

TEST_F(FindScenes, GivesTheScenesOfAFolderInNaturalOrder) {
  for (const char* file :
       {"learn10/depth.png", "learn2/depth.png", "learn2b/depth.png", "learn02/depth.png", "learn1/rgb.png",
        "learn3.pcd", "b.PCD", "notes.txt", ".c.pcd", ".d/depth.png", "picture.png", "learn.csv", "empty/x.txt"})
    folder_.write(file, "x");
  const std::vector<std::string> expected{"b.PCD", "learn1", "learn02", "learn2", "learn2b", "learn3.pcd", "learn10"};
  EXPECT_EQ(names({folder_.path()}), expected);
}

TEST_F(FindScenes, KeepsTheOrderOfThePaths) {
  for (const char* file : {"a/depth.png", "b/depth.png", "c.pcd"}) folder_.write(file, "x");
  const std::vector<std::string> expected{"c.pcd", "b", "a"};
  EXPECT_EQ(names({folder_.path() / "c.pcd", folder_.path() / "b", folder_.path() / "a"}), expected);
}

TEST_F(FindScenes, RefusesWhatHoldsNoScene) {
  const auto message = [&](const fs::path& path) { return error_of([&] { find_scenes({path}); }); };
  expect_parts(message(folder_.path()), {folder_.path().string() + ": contains no scene", "depth.png", ".pcd"});
  expect_parts(message(folder_.path() / "none"), {"none: does not exist"});
  expect_parts(message(folder_.write("cloud.obj", "x")), {"cloud.obj: is not a scene", ".pcd"});
}

TEST_F(FindScenes, RefusesTwoScenesOfOneName) {
  for (const char* file : {"a/s/depth.png", "b/s/depth.png", "c/s.pcd"}) folder_.write(file, "x");
  const auto message = [&](const std::vector<fs::path>& paths) { return error_of([&] { find_scenes(paths); }); };
  expect_parts(message({folder_.path() / "a", folder_.path() / "b/s"}),
               {"b/s: has the same name as ", "a/s", "rename"});
  expect_parts(message({folder_.path() / "a", folder_.path() / "c"}), {"c/s.pcd: has the same name as "});
  expect_parts(message({folder_.path() / "a", folder_.path() / "a/s/"}), {"has the same name as "});
}

TEST_F(FindScenes, NamesAScene) {
  folder_.write("my.scene/depth.png", "x");
  EXPECT_EQ(scene_name(folder_.path() / "my.scene"), "my.scene");
  EXPECT_EQ(scene_name(folder_.path() / "my.scene/"), "my.scene");
  EXPECT_EQ(scene_name(folder_.path() / "my.scene/."), "my.scene");
  EXPECT_EQ(scene_name(folder_.path() / "learn0.pcd"), "learn0");
}

}  // namespace
}  // namespace gestalt
