// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "drawing.h"
#include "gestalt/io/result/result.h"
#include "segment_colours.h"

namespace gestalt {

namespace {

/// Labels, with those of the nearest labelled pixel in gaps of up to 64 pixels of 640 x 480: depth lacks pixels
/// everywhere, and their outlines would hide those of the objects.
cv::Mat_<std::uint16_t> without_gaps(const cv::Mat_<std::uint16_t>& labels) {
  const std::size_t largest_gap = std::max<std::size_t>(64, labels.total() / (640 * 480 / 64));
  const cv::Mat missing = labels == 0;
  cv::Mat_<int> gaps, nearest;
  cv::Mat areas, centres, distances;
  cv::connectedComponentsWithStats(missing, gaps, areas, centres, 8, CV_32S);
  cv::distanceTransform(missing, distances, nearest, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);

  std::vector<std::uint16_t> label_of(labels.total() + 1, 0);  // by the number in nearest of a labelled pixel
  for (int v = 0; v < labels.rows; ++v)
    for (int u = 0; u < labels.cols; ++u)
      if (labels(v, u) > 0) label_of[std::size_t(nearest(v, u))] = labels(v, u);

  cv::Mat_<std::uint16_t> filled = labels.clone();
  for (int v = 0; v < labels.rows; ++v)
    for (int u = 0; u < labels.cols; ++u)
      if (labels(v, u) == 0 && std::size_t(areas.at<int>(gaps(v, u), cv::CC_STAT_AREA)) <= largest_gap)
        filled(v, u) = label_of[std::size_t(nearest(v, u))];
  return filled;
}

/// The pixel of a region that is farthest from its border.
cv::Point middle_of(const cv::Mat& mask) {
  cv::Mat framed, distances;
  cv::copyMakeBorder(mask, framed, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::distanceTransform(framed, distances, cv::DIST_L2, cv::DIST_MASK_3);
  cv::Point farthest;
  cv::minMaxLoc(distances, nullptr, nullptr, nullptr, &farthest);
  return farthest - cv::Point(1, 1);
}

std::vector<cv::Rect> boxes_of(const cv::Mat_<std::uint16_t>& labels, std::size_t count) {
  std::vector<cv::Rect> boxes(count);
  for (int v = 0; v < labels.rows; ++v)
    for (int u = 0; u < labels.cols; ++u)
      if (labels(v, u) > 0) boxes[std::size_t(labels(v, u)) - 1] |= cv::Rect(u, v, 1, 1);
  return boxes;
}

/// Centred at a pixel, white with a black rim.
void write_number(cv::Mat& picture, int number, cv::Point at) {
  const double scale = std::max(picture.rows, 240) / 1200.0;
  const std::string text = std::to_string(number);
  int below = 0;
  const cv::Size size = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, scale, 1, &below);
  const cv::Point origin = at + cv::Point(-size.width / 2, size.height / 2);
  const int stroke = std::max(1, int(2 * scale));
  cv::putText(picture, text, origin, cv::FONT_HERSHEY_SIMPLEX, scale, {0, 0, 0}, 3 * stroke, cv::LINE_AA);
  cv::putText(picture, text, origin, cv::FONT_HERSHEY_SIMPLEX, scale, {255, 255, 255}, stroke, cv::LINE_AA);
}

}  // namespace

cv::Mat draw_segments(const Frame& frame, const Segmentation& segmentation) {
  const cv::Mat_<std::uint16_t> labels = without_gaps(segmentation.labels);
  const auto object_at = [&](int v, int u) {
    const int label = labels(v, u);
    return label > 0 && segmentation.segments[std::size_t(label) - 1].role == Role::object ? label : 0;
  };
  const std::vector<cv::Vec3b> colours = segment_colours(segmentation);
  const cv::Mat below = backdrop(frame);
  cv::Mat picture(labels.size(), CV_8UC3);
  for (int v = 0; v < labels.rows; ++v)
    for (int u = 0; u < labels.cols; ++u) {
      const int own = object_at(v, u);
      const auto ends = [&](int x, int y) { return x < labels.cols && y < labels.rows && object_at(y, x) != own; };
      const cv::Vec3b& base = below.at<cv::Vec3b>(v, u);
      auto& pixel = picture.at<cv::Vec3b>(v, u);
      if (ends(u + 1, v) || ends(u, v + 1) || ends(u + 1, v + 1))
        pixel = {255, 255, 255};
      else
        pixel = own > 0 ? cv::Vec3b(base * 0.5 + colours[std::size_t(own) - 1] * 0.5) : base;
    }

  const std::vector<cv::Rect> boxes = boxes_of(labels, segmentation.segments.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (segmentation.segments[i].role == Role::object && !boxes[i].empty())
      write_number(picture, int(i) + 1, boxes[i].tl() + middle_of(labels(boxes[i]) == int(i) + 1));
  return picture;
}

}  // namespace gestalt
