// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/images.h"

#include <opencv2/imgproc.hpp>

#include "gestalt/core/base/error.h"

namespace gestalt {

namespace {

cv::Mat converted(const Frame& frame, int code) {
  if (!frame.has_colour()) throw InputError(frame.name + ": a relation needs colour and the frame has none");
  cv::Mat result;
  cv::cvtColor(frame.colour, result, code);
  return result;
}

}  // namespace

Observation::~Observation() = default;
Observer::~Observer() = default;

std::unique_ptr<Observation> Observer::observe(const Images&) const { return nullptr; }

Images::Images(Frame frame) : frame_(std::move(frame)) {}

Images::~Images() = default;

const cv::Mat& Images::grey() const {
  std::call_once(grey_once_, [this] { grey_ = converted(frame_, cv::COLOR_BGR2GRAY); });
  return grey_;
}

const cv::Mat& Images::yuv() const {
  std::call_once(yuv_once_, [this] { yuv_ = converted(frame_, cv::COLOR_BGR2YUV); });
  return yuv_;
}

const Observation* Images::observation(const Observer& observer) const {
  {
    const std::lock_guard lock(observations_mutex_);
    if (const auto known = observations_.find(&observer); known != observations_.end()) return known->second.get();
  }
  std::unique_ptr<Observation> made = observer.observe(*this);
  const std::lock_guard lock(observations_mutex_);
  return observations_.try_emplace(&observer, std::move(made)).first->second.get();
}

void Images::forget_observations() { observations_.clear(); }

}  // namespace gestalt
