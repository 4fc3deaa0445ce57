// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/contour.h"

#include <tbb/parallel_for.h>

#include <opencv2/imgproc.hpp>

namespace gestalt {

namespace {

cv::Rect bounding_box(const std::vector<int>& pixels, int width) {
  int left = width, right = 0;
  for (const int pixel : pixels) {
    left = std::min(left, pixel % width);
    right = std::max(right, pixel % width);
  }
  const int top = pixels.front() / width, bottom = pixels.back() / width;
  return {left, top, right - left + 1, bottom - top + 1};
}

std::vector<Contour> contours_of(const std::vector<int>& pixels, int width) {
  const cv::Rect box = bounding_box(pixels, width);
  cv::Mat_<std::uint8_t> mask(box.size(), std::uint8_t{0});
  for (const int pixel : pixels) mask(pixel / width - box.y, pixel % width - box.x) = 1;
  std::vector<std::vector<cv::Point>> outlines;
  std::vector<cv::Vec4i> hierarchy;
  cv::findContours(mask, outlines, hierarchy, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE, box.tl());
  std::vector<Contour> contours;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    Contour& contour = contours.emplace_back();
    contour.hole = hierarchy[i][3] >= 0;
    for (const cv::Point& p : outlines[i]) contour.pixels.push_back(p.y * width + p.x);
  }
  return contours;
}

}  // namespace

std::vector<std::vector<Contour>> find_contours(const SurfaceSet& surfaces) {
  std::vector<std::vector<Contour>> contours(surfaces.surfaces.size());
  tbb::parallel_for(std::size_t{0}, contours.size(), [&](std::size_t i) {
    contours[i] = contours_of(surfaces.surfaces[i].pixels, surfaces.labels.cols);
  });
  return contours;
}

}  // namespace gestalt
