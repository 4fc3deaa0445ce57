// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/scene.h"

#include <opencv2/imgproc.hpp>

#include "gestalt/error.h"

namespace gestalt {

namespace {

cv::Mat converted(const Frame& frame, int code) {
  if (!frame.has_colour()) throw InputError(frame.name + ": a relation needs colour and the frame has none");
  cv::Mat result;
  cv::cvtColor(frame.colour, result, code);
  return result;
}

}  // namespace

Scene::Scene(const Frame& frame, const PatchMap& patches, const SurfaceSet& surfaces)
    : frame_(frame), patches_(patches), surfaces_(surfaces) {}

const cv::Mat& Scene::grey() const {
  std::call_once(grey_once_, [this] { grey_ = converted(frame_, cv::COLOR_BGR2GRAY); });
  return grey_;
}

const cv::Mat& Scene::yuv() const {
  std::call_once(yuv_once_, [this] { yuv_ = converted(frame_, cv::COLOR_BGR2YUV); });
  return yuv_;
}

const std::vector<std::vector<Contour>>& Scene::contours() const {
  std::call_once(contours_once_, [this] { contours_ = find_contours(surfaces_); });
  return contours_;
}

const BoundaryLines& Scene::boundary_lines() const {
  std::call_once(lines_once_, [this] { lines_ = find_boundary_lines(frame_, surfaces_, contours()); });
  return lines_;
}

const std::vector<Closure>& Scene::closures() const {
  std::call_once(closures_once_, [this] { closures_ = find_closures(frame_, surfaces_, boundary_lines()); });
  return closures_;
}

const std::vector<Outline>& Scene::outlines() const {
  std::call_once(outlines_once_, [this] { outlines_ = find_outlines(frame_, surfaces_, contours()); });
  return outlines_;
}

}  // namespace gestalt
