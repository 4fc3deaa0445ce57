// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/ground_truth.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "gestalt/core/base/error.h"
#include "gestalt/tests/environment/temporary_folder.h"

namespace gestalt::test {
namespace {

const cv::Mat measured = cv::Mat(2, 4, CV_8U, cv::Scalar(255));

cv::Mat_<int> row(std::initializer_list<int> values) {
  cv::Mat_<int> labels(2, 4);
  std::copy(values.begin(), values.end(), labels.begin());
  return labels;
}

std::string png(const cv::Mat& image) {
  std::vector<unsigned char> bytes;
  cv::imencode(".png", image, bytes);
  return {bytes.begin(), bytes.end()};
}

/// The labels that a scheme gives, as a text; "?" and the problem where it gives none.
std::string text(const Input& input) {
  if (!input.ground_truth_problem.empty()) return "? " + input.ground_truth_problem;
  std::string text;
  for (const std::uint16_t label : input.ground_truth) text += (text.empty() ? "" : " ") + std::to_string(label);
  return text;
}

std::string labels(std::initializer_list<int> values, LabelScheme scheme = LabelScheme::guess) {
  Input input;
  set_ground_truth(input, row(values), measured, scheme, "x");
  return text(input);
}

void expect_problem(const std::string& text, const std::string& part) {
  EXPECT_TRUE(text.starts_with("? ")) << text;
  EXPECT_NE(text.find(part), text.npos) << text;
}

TEST(GroundTruth, TheSchemeOfTheOsdStays) {
  EXPECT_EQ(labels({1, 1, 1, 20, 21, 30, 1, 2}), "1 1 1 20 21 30 1 2");
  EXPECT_EQ(labels({0, 0, 0, 0, 1, 20, 30, 30}), "0 0 0 0 1 20 30 30");  // much is ignored
  EXPECT_EQ(labels({1, 1, 1, 1, 1, 1, 1, 1}), "1 1 1 1 1 1 1 1");        // no object
  EXPECT_EQ(labels({20, 20, 21, 21, 30, 30, 30, 30}), "20 20 21 21 30 30 30 30");
}

TEST(GroundTruth, CountedObjectsGetTheirTens) {
  EXPECT_EQ(labels({0, 0, 0, 0, 1, 2, 3, 4}), "1 1 1 1 20 30 40 50");
  EXPECT_EQ(labels({0, 0, 0, 0, 0, 0, 1, 1}), "1 1 1 1 1 1 20 20");  // one mask
  EXPECT_EQ(labels({0, 0, 0, 0, 1, 9, 17, 21}), "1 1 1 1 20 100 180 220");
  EXPECT_EQ(labels({0, 0, 0, 255, 255, 0, 0, 0}), "1 1 1 2560 2560 1 1 1");
}

TEST(GroundTruth, WhatMayBeEitherIsNotGuessed) {
  for (const auto& values : {std::initializer_list<int>{0, 0, 0, 0, 1001, 1002, 1003, 1003},
                             {1, 1, 1, 2, 3, 4, 5, 12},
                             {0, 0, 0, 0, 0, 1, 21, 22}}) {
    expect_problem(labels(values), "--labels objects or --labels osd");
    EXPECT_EQ(labels(values, LabelScheme::objects)[0] == '?', false);
    EXPECT_EQ(labels(values, LabelScheme::osd)[0] == '?', false);
  }
}

TEST(GroundTruth, LargeNumbersAreCountedAnew) {
  EXPECT_EQ(labels({0, 0, 0, 0, 7000, 9000, 65535, 65535}, LabelScheme::objects), "1 1 1 1 20 30 40 40");
}

TEST(GroundTruth, PixelsWithoutDepthAreIgnored) {
  Input input;
  cv::Mat some = measured.clone();
  some.at<std::uint8_t>(0, 0) = some.at<std::uint8_t>(1, 3) = 0;
  set_ground_truth(input, row({0, 0, 0, 0, 1, 2, 2, 2}), some, LabelScheme::objects, "x");
  EXPECT_EQ(text(input), "0 1 1 1 20 30 30 0");
}

class GroundTruthFolder : public testing::Test {
 protected:
  Input read(LabelScheme scheme = LabelScheme::guess) const {
    Input input;
    input.path = folder_.path();
    read_ground_truth_beside(input, folder_.path(), measured, scheme);
    return input;
  }

  TemporaryFolder folder_;
};

TEST_F(GroundTruthFolder, HoldsNone) {
  const Input input = read();
  EXPECT_TRUE(input.ground_truth.empty());
  EXPECT_TRUE(input.ground_truth_problem.empty());
  EXPECT_THROW(require_ground_truth(input), InputError);
}

TEST_F(GroundTruthFolder, ColoursAreObjects) {
  cv::Mat_<cv::Vec3b> image(2, 4, cv::Vec3b(0, 0, 0));
  image(0, 1) = image(0, 2) = {0, 0, 255};
  image(1, 3) = {0, 255, 0};
  folder_.write("label.png", png(image));
  EXPECT_EQ(text(read()), "1 20 20 1 1 1 1 30");
  EXPECT_EQ(read().notes.size(), 1U);
  for (cv::Vec3b& colour : image)
    if (colour == cv::Vec3b(0, 0, 0)) colour = {9, 8, 7};
  folder_.write("label.png", png(image));
  expect_problem(text(read()), "--labels colours");
  EXPECT_EQ(text(read(LabelScheme::colours)), "1 20 20 1 1 1 1 30");
  expect_problem(text(read(LabelScheme::osd)), "--labels colours");
}

TEST_F(GroundTruthFolder, DamagedLabelsAreAWarning) {
  folder_.write("label.png", "no image");
  const Input input = read();
  EXPECT_TRUE(input.ground_truth.empty());
  ASSERT_EQ(input.warnings.size(), 1U);
  EXPECT_NE(input.warnings[0].find("label.png"), std::string::npos);
  EXPECT_THROW(require_ground_truth(input), InputError);
  folder_.write("label.png", png(cv::Mat(1, 1, CV_8U, cv::Scalar(3))));
  expect_problem(text(read()), "is 1x1, depth is 4x2");
}

TEST_F(GroundTruthFolder, EachMaskIsAnObject) {
  for (const int object : {1, 2, 10}) {
    cv::Mat_<std::uint8_t> mask(2, 4, std::uint8_t{0});
    mask(1, object % 4) = 255;
    folder_.write("masks/" + std::to_string(object) + ".png", png(mask));
  }
  EXPECT_EQ(text(read()), "1 1 1 1 1 20 40 1");  // natural order: the third lies over the second
}

TEST_F(GroundTruthFolder, InstancesOfCocoAreObjects) {
  const auto coco = [&](const std::string& segmentation) {
    folder_.write("coco.json",
                  R"({"images": [{"id": 3, "width": 4, "height": 2, "file_name": "a.png"}], "annotations": [
      {"image_id": 3, "segmentation": )" +
                      segmentation + R"(}, {"image_id": 4, "segmentation": []},
      {"image_id": 3, "iscrowd": 1, "segmentation": {"size": [2, 4], "counts": [0, 8]}}]})");
    return text(read());
  };
  EXPECT_EQ(coco(R"({"size": [2, 4], "counts": [3, 2, 3]})"), "1 1 20 1 1 20 1 1");
  EXPECT_EQ(coco(R"({"size": [2, 4], "counts": "323"})"), "1 1 20 1 1 20 1 1");
  EXPECT_EQ(coco("[[1, 0, 3, 0, 3, 1, 1, 1]]"), "1 20 20 1 1 1 1 1");
  expect_problem(coco(R"({"size": [2, 4], "counts": [3, 9]})"), "annotation 1: its counts are more");
  expect_problem(coco(R"({"size": [2, 4], "counts": [3, 2]})"), "annotation 1: its counts are fewer");
  expect_problem(coco(R"({"size": [4, 2], "counts": [8]})"), "differs in size");
  expect_problem(coco(R"({"size": [2, 4], "counts": "~~"})"), "damaged");
  expect_problem(coco("[[1, 0, 3]]"), "three corners");
  expect_problem(coco("7"), "no segmentation");
  folder_.write("coco.json", "{");
  expect_problem(text(read()), "coco.json:1:2: is not valid JSON");
  folder_.write("coco.json", R"({"images": [], "annotations": []})");
  expect_problem(text(read()), "has 0 images of 4x2");
}

}  // namespace
}  // namespace gestalt::test
