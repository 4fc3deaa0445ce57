// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/images.h"

#include <opencv2/imgproc.hpp>

#include "gestalt/error.h"
#include "gestalt/relation.h"

namespace gestalt {

namespace {

cv::Mat converted(const Frame& frame, int code) {
  if (!frame.has_colour()) throw InputError(frame.name + ": a relation needs colour and the frame has none");
  cv::Mat result;
  cv::cvtColor(frame.colour, result, code);
  return result;
}

}  // namespace

Images::Images(const Frame& frame) : frame_(frame) {}

Images::~Images() = default;

const cv::Mat& Images::grey() const {
  std::call_once(grey_once_, [this] { grey_ = converted(frame_, cv::COLOR_BGR2GRAY); });
  return grey_;
}

const cv::Mat& Images::yuv() const {
  std::call_once(yuv_once_, [this] { yuv_ = converted(frame_, cv::COLOR_BGR2YUV); });
  return yuv_;
}

const Observation* Images::observation(const Relation& relation) const {
  {
    const std::lock_guard lock(observations_mutex_);
    if (const auto known = observations_.find(&relation); known != observations_.end()) return known->second.get();
  }
  std::unique_ptr<Observation> made = relation.observe(*this);
  const std::lock_guard lock(observations_mutex_);
  return observations_.try_emplace(&relation, std::move(made)).first->second.get();
}

}  // namespace gestalt
