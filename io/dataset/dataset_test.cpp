// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/dataset/labelled_cloud.h"
#include "gestalt/io/dataset/osd_release.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "gestalt/core/base/error.h"
#include "gestalt/tests/environment/temporary_folder.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;
using Image16 = cv::Mat_<std::uint16_t>;

template <class Pixel = std::uint16_t>
cv::Mat_<Pixel> image(int rows, int columns, std::vector<int> pixels) {
  cv::Mat_<Pixel> result(rows, columns);
  std::transform(pixels.begin(), pixels.end(), result.begin(), [](int pixel) { return Pixel(pixel); });
  return result;
}

constexpr Camera small{4, 3, 5, 5, 1.5, 1};

/// A release with one scene of 4x3 pixels.
class OsdRelease : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"disparity", "image_color", "annotation"}) fs::create_directory(folder.path() / name);
    write("disparity/learn20.png", image(3, 4, {1000, 1001, 0, 1003, 1004, 0, 1006, 1007, 1008, 1009, 1010, 1011}));
    write("image_color/learn20.png", cv::Mat(3, 4, CV_8UC3, cv::Scalar(1, 2, 3)));
    write("annotation/learn20.png", image<std::uint8_t>(3, 4, {0, 1, 1, 1, 0, 2, 2, 2, 0, 0, 0, 0}));
  }
  void write(const char* name, const cv::Mat& image) const {
    ASSERT_TRUE(cv::imwrite(folder.path() / name, image)) << name;
  }
  void expect_error(const std::string& name, const std::vector<std::string>& words) const {
    try {
      read_osd_scene(folder.path(), name, CameraFile(small));
      FAIL() << "read";
    } catch (const InputError& error) {
      for (const std::string& word : words)
        EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << word << " not in " << error.what();
    }
  }
  const TemporaryFolder folder;
};

TEST_F(OsdRelease, DepthStaysAndObjectsGetOurNumbers) {
  const ConvertedScene scene = read_osd_scene(folder.path(), "learn20", CameraFile(small));
  EXPECT_EQ(scene.images.depth(0, 1), 1001);
  EXPECT_EQ(scene.images.colour.at<cv::Vec3b>(0, 0), cv::Vec3b(1, 2, 3));
  const Image16 expected = image(3, 4, {1, 20, 0, 20, 1, 0, 30, 30, 1, 1, 1, 1});
  EXPECT_EQ(cv::norm(scene.images.label, expected, cv::NORM_INF), 0) << scene.images.label;
  EXPECT_EQ(scene.objects, 2);
  EXPECT_EQ(scene.camera.width, 4);
}

TEST_F(OsdRelease, ScenesAreThoseOfAllFoldersInNaturalOrder) {
  write("disparity/learn3.png", Image16(3, 4, std::uint16_t{900}));
  write("annotation/test0.png", cv::Mat_<std::uint8_t>(3, 4, std::uint8_t{0}));
  folder.write("disparity/readme.txt", "no scene");
  EXPECT_EQ(find_osd_scenes(folder.path()), (std::vector<std::string>{"learn3", "learn20", "test0"}));
  expect_error("learn3", {"image_color/learn3.png", "does not exist"});
  expect_error("test0", {"disparity/test0.png", "does not exist"});
}

TEST_F(OsdRelease, AFolderWithoutThemIsRefused) {
  fs::remove_all(folder.path() / "annotation");
  EXPECT_THROW(find_osd_scenes(folder.path()), InputError);
  fs::create_directory(folder.path() / "annotation");
  EXPECT_NO_THROW(find_osd_scenes(folder.path()));
  for (const char* name : {"disparity", "image_color"}) fs::remove(folder.path() / name / "learn20.png");
  EXPECT_THROW(find_osd_scenes(folder.path()), InputError);
}

TEST_F(OsdRelease, ImagesMustFitEachOtherAndTheCamera) {
  EXPECT_THROW(read_osd_scene(folder.path(), "learn20"), InputError);  // the database's camera is 640x480
  write("annotation/learn20.png", cv::Mat_<std::uint8_t>(3, 5, std::uint8_t{0}));
  expect_error("learn20", {"annotation/learn20.png", "5x3", "4x3"});
  write("annotation/learn20.png", cv::Mat(3, 4, CV_8UC3, cv::Scalar(1, 1, 1)));
  expect_error("learn20", {"annotation/learn20.png", "label numbers, not colours"});
  write("annotation/learn20.png", Image16(3, 4, std::uint16_t{6553}));
  expect_error("learn20", {"annotation/learn20.png", "6553", "column 0, row 0"});
  write("disparity/learn20.png", cv::Mat_<std::uint8_t>(3, 4, std::uint8_t{9}));
  expect_error("learn20", {"disparity/learn20.png", "8-bit"});
  write("disparity/learn20.png", Image16(3, 4, std::uint16_t{0}));
  expect_error("learn20", {"disparity/learn20.png", "no pixel has a measurement"});
}

TEST(OsdNames, CategoriesAreThoseOfTheReadme) {
  std::map<std::string, std::map<std::string, int>> counts;
  for (int i = 0; i < 100; ++i)
    for (const std::string set : {"learn", "test"}) {
      const OsdScene scene = osd_scene(set + std::to_string(i));
      EXPECT_EQ(scene.set, scene.category.empty() ? "scenes" : set);
      ++counts[set][scene.category];
    }
  // Table 1 of the paper.
  EXPECT_EQ(counts["learn"],
            (std::map<std::string, int>{
                {"boxes", 17}, {"stacked_boxes", 8}, {"occluded_objects", 8}, {"cylindric_objects", 12}, {"", 55}}));
  EXPECT_EQ(counts["test"], (std::map<std::string, int>{{"boxes", 16},
                                                        {"stacked_boxes", 8},
                                                        {"occluded_objects", 7},
                                                        {"cylindric_objects", 12},
                                                        {"mixed_objects", 12},
                                                        {"complex_scene", 11},
                                                        {"", 34}}));
  for (const char* name : {"learn", "learn-1", "learn1x", "learn3_unorganized", "kitchen7", ""}) {
    EXPECT_EQ(osd_scene(name).set, "scenes") << name;
    EXPECT_EQ(osd_scene(name).category, "") << name;
  }
}

/// An ascii cloud of 2x2 points with labels, 1 m away.
std::string cloud(const std::string& labels) {
  std::istringstream values(labels);
  std::string text =
      "VERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 2\n"
      "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA ascii\n";
  for (const char* point : {"-0.5 -0.5 1 ", "0.5 -0.5 1 ", "-0.5 0.5 1.0006 ", "0.5 0.5 70 "}) {
    std::string label;
    values >> label;
    text += point + label + "\n";
  }
  return text;
}

TEST(LabelledClouds, KeepOurLabelsAndCountOthers) {
  const TemporaryFolder folder;
  const CameraFile camera(Camera{2, 2, 1, 1, 0.5, 0.5});
  std::string text = cloud("1 20 30 30");
  text.replace(text.find("70 30"), 2, "2 ");
  const ConvertedScene ours = read_labelled_cloud(folder.write("a.pcd", text), camera);
  EXPECT_EQ(cv::norm(ours.images.label, image(2, 2, {1, 20, 30, 30}), cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(ours.images.depth, image(2, 2, {1000, 1000, 1001, 2000}), cv::NORM_INF), 0);
  EXPECT_TRUE(ours.images.colour.empty());
  EXPECT_EQ(ours.objects, 2);

  text = cloud("0 1 2 2");
  text.replace(text.find("70 2"), 2, "2 ");
  const fs::path file = folder.write("b.pcd", text);
  for (const LabelScheme scheme : {LabelScheme::guess, LabelScheme::objects}) {
    ReadOptions options(camera);
    options.labels = scheme;
    const ConvertedScene counted = read_labelled_cloud(file, options);
    EXPECT_EQ(cv::norm(counted.images.label, image(2, 2, {1, 20, 30, 30}), cv::NORM_INF), 0);
  }
  ReadOptions osd(camera);
  osd.labels = LabelScheme::osd;
  EXPECT_THROW(read_labelled_cloud(file, osd), InputError);  // would be all background
}

TEST(LabelledClouds, BeyondSixteenBitsOfMillimetresAreRefused) {
  const TemporaryFolder folder;
  const CameraFile camera(Camera{2, 2, 1, 1, 0.5, 0.5});
  EXPECT_THROW(read_labelled_cloud(folder.write("a.pcd", cloud("1 20 30 30")), camera), InputError);
}

TEST(LabelledClouds, NeedLabelsOnlyWhereTheirMeaningIsTold) {
  const TemporaryFolder folder;
  std::string text = cloud("1 1 1 1");
  text.replace(text.find("label"), 5, "other");
  text.replace(text.find("70 1"), 2, "2 ");
  ReadOptions options(Camera{2, 2, 1, 1, 0.5, 0.5});
  const std::filesystem::path file = folder.write("a.pcd", text);
  EXPECT_TRUE(read_labelled_cloud(file, options).images.label.empty());
  options.labels = LabelScheme::osd;
  EXPECT_THROW(read_labelled_cloud(file, options), InputError);
}

}  // namespace
}  // namespace gestalt::test
