// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/input.h"
#include "gestalt/io/scene/scene_folder.h"
#include "gestalt/tests/environment/temporary_folder.h"

namespace gestalt {
namespace {

namespace fs = std::filesystem;

class CameraFormats : public testing::Test {
 protected:
  CameraFile read(const std::string& text, const std::string& name = "camera") const {
    return read_camera(folder_.write(name, text));
  }

  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << "not refused: " << text;
    return "";
  }

  /// Of this camera, unless the size is not told.
  void expect_camera(const std::string& text, bool sized = true) const {
    const Camera c = read(text).camera;
    EXPECT_EQ(c.width, sized ? 640 : 0) << text;
    EXPECT_EQ(c.height, sized ? 480 : 0) << text;
    EXPECT_DOUBLE_EQ(c.fx, 525) << text;
    EXPECT_DOUBLE_EQ(c.fy, 526.5) << text;
    EXPECT_DOUBLE_EQ(c.cx, 319.5) << text;
    EXPECT_DOUBLE_EQ(c.cy, 239.25) << text;
  }

  test::TemporaryFolder folder_;
};

const std::string rows = "[525, 0, 319.5, 0, 526.5, 239.25, 0, 0, 1]";
const std::string columns = "[525, 0, 0, 0, 526.5, 0, 319.5, 239.25, 1]";
const std::string nested = "[[525, 0, 319.5], [0, 526.5, 239.25], [0, 0, 1]]";

TEST_F(CameraFormats, OfRos) {
  expect_camera("height: 480\nwidth: 640\ndistortion_model: plumb_bob\nD: [0.0, 0.0]\nK: " + rows + "\n");
  expect_camera("height: 480\nwidth: 640\ndistortion_model: plumb_bob\nd: []\nk: " + rows + "\n---\n");
  const Camera part = read("height: 480\nwidth: 640\nD: []\nK: " + rows +
                           "\nroi: {x_offset: 20, y_offset: 10, height: 240, width: 320, do_rectify: false}\n")
                          .camera;
  EXPECT_EQ(part.width, 320);
  EXPECT_DOUBLE_EQ(part.cx, 299.5);
  EXPECT_DOUBLE_EQ(part.cy, 229.25);
}

TEST_F(CameraFormats, OfOpenCv) {
  expect_camera(
      "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n"
      "   dt: d\n   data: " +
      rows + "\n");
  expect_camera(
      "{\"image_width\": 640, \"image_height\": 480, \"cameraMatrix\": {\"type_id\": \"opencv-matrix\", \"rows\": 3, "
      "\"cols\": 3, \"dt\": \"d\", \"data\": " +
      rows + "}, \"distCoeffs\": [[0, 0, 0, 0, 0]]}");
  expect_camera(
      "<?xml version=\"1.0\"?>\n<opencv_storage>\n<image_width>640</image_width><image_height>480</image_height>\n"
      "<camera_matrix type_id=\"opencv-matrix\"><rows>3</rows><cols>3</cols><dt>d</dt><data>\n"
      "525. 0. 3.195e+02 0. 5.265e2 239.25 0. 0. 1.</data></camera_matrix></opencv_storage>\n");
  EXPECT_NE(refusal("<a><b></a>").find("is not valid XML"), std::string::npos);
}

TEST_F(CameraFormats, OfMatricesInJson) {
  expect_camera("{\"width\": 640, \"height\": 480, \"intrinsic_matrix\": " + columns + "}");
  expect_camera("{\n\t\"intrinsic\": {\"width\": 640, \"height\": 480, \"intrinsic_matrix\": " + columns + "}}");
  expect_camera("{\"cam_K\": " + rows + ", \"depth_scale\": 0.1}", false);
  EXPECT_DOUBLE_EQ(read("{\"cam_K\": " + rows + ", \"depth_scale\": 0.1}").depth_scale.value_or(0), 0.0001);
  expect_camera("{\"0\": {\"cam_K\": " + rows + "}, \"1\": {\"cam_K\": " + rows + "}}", false);
  expect_camera("{\"K\": " + columns + ", \"w\": 640, \"h\": 480, \"fps\": 60}");
  expect_camera("{\"intrinsics\": " + nested + ", \"imageResolution\": [640, 480]}");
}

TEST_F(CameraFormats, OfNamedNumbers) {
  expect_camera(
      "{\"color\": {\"width\": 640, \"height\": 480, \"fx\": 525, \"fy\": 526.5, \"ppx\": 319.5, \"ppy\": 239.25, "
      "\"coeffs\": [0, 0, 0, 0, 0]}}");
  expect_camera(
      "{\"_cy\": 239.25, \"_cx\": 319.5, \"_fy\": 526.5, \"_height\": 480, \"_width\": 640, \"_fx\": 525, \"_skew\": "
      "0.0}");
  expect_camera(
      "{\"w\": 640, \"h\": 480, \"fl_x\": 525, \"fl_y\": 526.5, \"cx\": 319.5, \"cy\": 239.25, \"frames\": []}");
  const std::string orb =
      "%YAML:1.0\nCamera.type: \"PinHole\"\nCamera.fx: 525.0\nCamera.fy: 526.5\nCamera.cx: 319.5\nCamera.cy: 239.25\n";
  expect_camera(orb, false);
  expect_camera(orb + "Camera.width: 640\nCamera.height: 480\n");
  EXPECT_DOUBLE_EQ(read(orb + "DepthMapFactor: 5000.0\n").depth_scale.value_or(0), 0.0002);
  expect_camera(
      "cam0:\n  camera_model: pinhole\n  distortion_coeffs: [0, 0, 0, 0]\n  distortion_model: radtan\n"
      "  intrinsics: [525, 526.5, 319.5, 239.25]\n  resolution: [640, 480]\n");
  expect_camera(
      "{\"fx\": 525, \"fy\": 526.5, \"cx\": 319.5, \"cy\": 239.25, \"width\": 640, \"height\": 480, \"t_00\": 1}");
}

TEST_F(CameraFormats, OfAssignments) {
  expect_camera(
      "appVersionId = 56\naxisAlignment = 0.945519 0.325568 0.000000 -5.384390\ncolorHeight = 968\ncolorWidth = 1296\n"
      "depthHeight = 480\ndepthWidth = 640\nfx_color = 1170.187988\nfx_depth = 525\nfy_color = 1170.187988\n"
      "fy_depth = 526.5\nmx_color = 647.75\nmx_depth = 319.5\nmy_color = 483.75\nmy_depth = 239.25\n"
      "sceneType = Bedroom / Hotel's: 'a'\r\n");
  const std::string sens =
      "m_versionNumber = 4\nm_sensorName = StructureSensor\nm_colorWidth = 1296\nm_depthWidth = 640\nm_depthHeight = "
      "480\nm_depthShift = 1000\nm_calibrationColorIntrinsic = 1170 0 647.75 0 0 1170 483.75 0 0 0 1 0 0 0 0 1 \n"
      "m_calibrationDepthIntrinsic = 525 0 319.5 0 0 526.5 239.25 0 0 0 1 0 0 0 0 1 \nm_frames.size = 5578\n";
  expect_camera(sens);
  EXPECT_DOUBLE_EQ(read(sens).depth_scale.value_or(0), 0.001);
  expect_camera("# of mine\n[camera]\nfx=525\nfy=526.5\ncx=319.5\n; more\ncy=239.25\nwidth=640\nheight=480\n");
  EXPECT_NE(refusal("fx = 525\nfy = wide\ncx = 319.5\ncy = 239.25\n").find("camera:2:6: fy is 'wide'"),
            std::string::npos);
  EXPECT_NE(refusal("fx_depth = 525\nfy_depth = 526.5\nmx_depth = 319.5\n").find("'my_depth' is missing"),
            std::string::npos);
}

TEST_F(CameraFormats, OfPlainText) {
  expect_camera("525 0 319.5\n0 526.5 239.25\n0 0 1\n", false);
  expect_camera("5.25e+02 0 3.195e+02 0\n0 526.5 239.25 0\n0 0 1 0\n0 0 0 1\n", false);
  expect_camera("[[525. 0. 319.5]\n [0. 526.5 239.25]\n [0. 0. 1.]]\n", false);
  expect_camera("525,0,319.5\n0,526.5,239.25\n0,0,1\n", false);
  expect_camera("640 480 525 526.5 319.5 239.25\n");
  expect_camera("# fx fy cx cy\n525 526.5 319.5 239.25\n", false);
  expect_camera("# CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n1 PINHOLE 640 480 525 526.5 320 239.75\n");
  EXPECT_EQ(read("1 OPENCV 640 480 525 526.5 320 240 0.1 0 0.01 0\n").lens.coefficients,
            (std::vector<double>{0.1, 0, 0.01, 0}));
  EXPECT_NE(refusal("1 PINHOLE 640 480 525 526.5 320\n").find("PINHOLE has 6 numbers"), std::string::npos);
  EXPECT_NE(refusal("1 PINHOLE 640 480 1 1 1 1\n2 PINHOLE 64 48 1 1 1 1\n").find("camera:2: a second camera"),
            std::string::npos);
  EXPECT_NE(refusal("525 0 319.5\n0 526.5 239.25\n0 1 1\n").find("0 0 1"), std::string::npos);
}

TEST_F(CameraFormats, AsPeopleWriteNumbers) {
  expect_camera("width: 640.0\nheight: \"480\"\nfx: 525,0\nfy: 526,5\ncx: 319,5\ncy: 239.25\n");
  expect_camera("fx: 525\nfy: 526.5\ncx: 319.5\ncy: 239.25\n", false);
  const CameraFile icl = read("width: 640\nheight: 480\nfx: 481.2\nfy: -480\ncx: 319.5\ncy: 239.5\n");
  EXPECT_DOUBLE_EQ(icl.camera.fy, 480);
  ASSERT_EQ(icl.notes.size(), 1u);
  EXPECT_NE(icl.notes[0].find("fy is negative"), std::string::npos);
  EXPECT_NE(refusal("width: 640\nheight: 480\nfx: 1,050\nfy: 1\ncx: 1\ncy: 1\n").find("fx is '1,050'"),
            std::string::npos);
}

TEST_F(CameraFormats, ScaleOfBopIsInMillimetres) {
  const std::string keys = "\"fx\": 525, \"fy\": 525, \"cx\": 319.5, \"cy\": 239.5, \"width\": 640, \"height\": 480";
  EXPECT_DOUBLE_EQ(read("{" + keys + ", \"depth_scale\": 0.1}").depth_scale.value_or(0), 0.0001);
  EXPECT_DOUBLE_EQ(read("{" + keys + ", \"depth_scale\": 0.001}").depth_scale.value_or(0), 0.001);
}

TEST_F(CameraFormats, WhatIsMissingIsNamedWithTheFormat) {
  const auto expect = [&](const std::string& text, const std::string& part) {
    const std::string message = refusal(text);
    EXPECT_NE(message.find(part), message.npos) << message;
  };
  expect("{\"width\": 640, \"height\": 480, \"fx\": 525, \"fy\": 525, \"ppx\": 319.5}",
         ":1:1: 'ppy' is missing: row of the principal point, which must lie in the image (read as RealSense's "
         "intrinsics)");
  expect("Camera.fx: 525\nCamera.fy: 525\nCamera.cx: 3\n", "'Camera.cy' is missing");
  expect("{\"width\": 640, \"height\": 480, \"intrinsic_matrix\": [1, 2]}", "(read as Open3D's intrinsics)");
  expect("cam0: {intrinsics: [1, 2, 3, 4], resolution: [6, 8]}\ncam1: {intrinsics: [1, 2, 4, 4], resolution: [6, 8]}\n",
         "holds several cameras ('cam0', 'cam1', ...)");
  expect("some: thing\n", "is not a camera file; it may be one of: ORB-SLAM's settings");
  expect("cam0: {camera_model: omni, intrinsics: [1, 2, 3, 4, 5]}\n", "is not a pinhole camera");
  expect("width: 6\nheight: 4\ndistortion_model: double_sphere\nD: [0.1]\nK: " + rows + "\n",
         "'double_sphere' cannot be read");
  expect("width: 6\nheight: 4\nK: [1, 0.5, 3, 0, 1, 2, 0, 0, 1]\n", "has skewed axes");
  for (const std::string key : {"K: ", "camera_matrix: ", "mtx: ", "intrinsic_matrix: ", "cam_K: ", "intrinsics: "}) {
    expect(key + "[9, 5, 3, 0, 9, 2, 0, 0, 1]\n", "has skewed axes");
    expect(key + "[9, 0, 3, 0, 9, 2, 0, 0, 2]\n", "must have the row 0 0 1");
    expect(key + "[[9, 0, 3], [1, 9, 2], [0, 0, 1]]\n", "has skewed axes");
  }
  expect("9 5 3\n0 9 2\n0 0 1\n", "has skewed axes");
  expect("K: " + rows + "\n---\nK: " + rows + "\n", ":3:1: is not valid YAML: second YAML document");
  expect("width: 6\nheight: 4\nfx: 1\nfy: 1\ncx: 1\ncy: 1\n---\nfx: 2\n", "second YAML document");
  expect("9 0 3\n0 9 2\n0 0 0.5\n", "must have the row 0 0 1");
}

TEST_F(CameraFormats, MayBeText16BitsWide) {
  std::string wide = "\xff\xfe";
  for (const char letter : std::string("525 0 319.5\r\n0 526.5 239.25\r\n0 0 1\r\n")) wide += {letter, '\0'};
  expect_camera(wide, false);
}

// A wall with one pixel that is nearer, labelled and coloured.
class OfALens : public CameraFormats {
 protected:
  Input read_with(const std::string& lens, cv::Point mark) const {
    const fs::path scene = folder_.path() / "scene";
    SceneImages images;
    images.depth = cv::Mat_<std::uint16_t>(160, 200, std::uint16_t{1000});
    images.colour = cv::Mat(160, 200, CV_8UC3, cv::Scalar(0, 0, 0));
    images.label = cv::Mat_<std::uint16_t>(160, 200, std::uint16_t{1});
    images.depth(mark) = 500;
    images.colour.at<cv::Vec3b>(mark) = {1, 2, 3};
    images.label(mark) = 20;
    write_scene_folder(scene, images);
    folder_.write("scene/camera.yaml", "width: 200\nheight: 160\nfx: 200\nfy: 200\ncx: 99.5\ncy: 79.5\n" + lens);
    return read_scene(scene);
  }

  /// Where the ray of a pixel is seen, whose radius the lens multiplies with a factor.
  static cv::Point seen(cv::Point pixel, double factor) {
    return {int(std::lround(99.5 + factor * (pixel.x - 99.5))), int(std::lround(79.5 + factor * (pixel.y - 79.5)))};
  }

  static double radius(cv::Point pixel) { return std::hypot((pixel.x - 99.5) / 200, (pixel.y - 79.5) / 200); }

  void expect_rectified(const std::string& lens, double factor) const {
    const Input input = read_with(lens, seen(pixel_, factor));
    EXPECT_EQ(input.frame.depth(pixel_), 0.5F) << lens;
    EXPECT_EQ(input.ground_truth(pixel_), 20);
    EXPECT_EQ(input.frame.colour.at<cv::Vec3b>(pixel_), cv::Vec3b(1, 2, 3));
    ASSERT_EQ(input.notes.size(), 1U);
    EXPECT_NE(input.notes[0].find("the images are rectified"), std::string::npos) << input.notes[0];
  }

  const cv::Point pixel_{160, 120};
};

TEST_F(OfALens, SmallDistortionIsAWarning) {
  const Input input = read_with("k1: 0.01\n", pixel_);
  EXPECT_EQ(input.frame.depth(pixel_), 0.5F);
  EXPECT_TRUE(std::any_of(input.warnings.begin(), input.warnings.end(), [](const std::string& warning) {
    return warning.find("its lens moves pixels by up to 0.5 px") != warning.npos;
  }));
}

TEST_F(OfALens, LargeDistortionIsRectified) {
  const double r = radius(pixel_), theta = std::atan(r);
  expect_rectified("k1: 0.1\n", 1 + 0.1 * r * r);
  expect_rectified("k1: -0.3\nk2: 0.1\n", 1 - 0.3 * r * r + 0.1 * std::pow(r, 4));
  expect_rectified("k1: 0.2\nk4: 0.4\n", (1 + 0.2 * r * r) / (1 + 0.4 * r * r));
  expect_rectified("distortion_model: equidistant\nk1: 0.05\n", theta * (1 + 0.05 * theta * theta) / r);
}

TEST_F(OfALens, ThatMovesPixelsFartherThanTheImageIsRefused) {
  EXPECT_THROW(read_with("k1: 100\nk2: 1000\n", pixel_), InputError);
}

// r (1 - 0.9 r^2) falls beyond r = 0.61: the corners are not known.
TEST_F(OfALens, WhatItDoesNotKnowHasNoDepth) {
  const Input input = read_with("k1: -0.9\n", pixel_);
  EXPECT_EQ(input.frame.depth(0, 0), 0.0F);
  EXPECT_GT(input.frame.depth(80, 100), 0.0F);
}

TEST_F(CameraFormats, OfAnotherResolutionAreScaled) {
  const fs::path scene = folder_.path() / "scene";
  SceneImages images;
  images.depth = cv::Mat_<std::uint16_t>(30, 40, std::uint16_t{1000});
  write_scene_folder(scene, images);
  folder_.write("scene/camera.yaml", "width: 80\nheight: 60\nfx: 90\nfy: 92\ncx: 39.5\ncy: 30\n");
  const Input input = read_scene(scene);
  EXPECT_DOUBLE_EQ(input.frame.camera.fx, 45);
  EXPECT_DOUBLE_EQ(input.frame.camera.cx, 19.5);
  EXPECT_DOUBLE_EQ(input.frame.camera.cy, 14.75);
  ASSERT_EQ(input.notes.size(), 1U);
  EXPECT_NE(input.notes[0].find("is for 80x60 images; it is scaled to 40x30"), std::string::npos);
  folder_.write("scene/camera.yaml", "width: 80\nheight: 45\nfx: 90\nfy: 92\ncx: 39.5\ncy: 20\n");
  EXPECT_THROW(read_scene(scene), InputError);
  folder_.write("scene/camera.yaml", "fx: 45\nfy: 45\ncx: 39.5\ncy: 29.5\n");
  const Input corner = read_scene(scene);  // of 80x60, most likely
  EXPECT_TRUE(std::any_of(corner.warnings.begin(), corner.warnings.end(), [](const std::string& warning) {
    return warning.find("is far from the middle") != warning.npos;
  }));
}

}  // namespace
}  // namespace gestalt
