// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// OpenCV's reader and writer of PNG files are the reference.

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/output_file.h"
#include "gestalt/io/scene/png_codec.h"

namespace gestalt {
namespace {

cv::Mat random_image(int type, cv::Size size) {
  cv::Mat image(size, type);
  cv::RNG(7).fill(image, cv::RNG::UNIFORM, 0, 65536, false);
  return image;
}

TEST(EncodePng, WritesWhatOpenCvReads) {
  for (const int type : {CV_8UC1, CV_16UC1, CV_8UC3})
    for (const cv::Size size : {cv::Size(1, 1), cv::Size(7, 5), cv::Size(640, 3)}) {
      const cv::Mat image = random_image(type, size);
      const std::string bytes = encode_png(image);
      const cv::Mat read = cv::imdecode(std::vector<uchar>(bytes.begin(), bytes.end()), cv::IMREAD_UNCHANGED);
      ASSERT_EQ(read.type(), type);
      ASSERT_EQ(read.size(), size);
      EXPECT_EQ(cv::norm(read, image, cv::NORM_INF), 0);
    }
}

TEST(EncodePng, WritesAPartOfAnImage) {
  const cv::Mat image = random_image(CV_8UC3, {20, 20}), part = image(cv::Rect(3, 4, 9, 7));
  const std::string bytes = encode_png(part);
  const cv::Mat read = cv::imdecode(std::vector<uchar>(bytes.begin(), bytes.end()), cv::IMREAD_UNCHANGED);
  EXPECT_EQ(cv::norm(read, part, cv::NORM_INF), 0);
}

TEST(EncodePng, RefusesWhatPngDoesNotHold) {
  EXPECT_THROW(encode_png(cv::Mat()), OutputError);
  EXPECT_THROW(encode_png(cv::Mat(2, 2, CV_32FC1)), OutputError);
  EXPECT_THROW(encode_png(cv::Mat(2, 2, CV_16UC3)), OutputError);
}

}  // namespace
}  // namespace gestalt
