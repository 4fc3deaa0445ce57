// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <opencv2/core.hpp>

#include "gestalt/frame.h"

namespace gestalt {

class Observation;
class Relation;

/// A frame's images, and what is derived from them alone. Each is made once, by whoever asks first; asking is
/// thread-safe. Keeps a reference: the frame must outlive it.
class GESTALT_EXPORT Images {
 public:
  explicit Images(const Frame& frame);
  ~Images();
  Images(const Images&) = delete;
  Images& operator=(const Images&) = delete;

  const Frame& frame() const { return frame_; }

  /// CV_8UC1. Throws InputError when the frame has no colour.
  const cv::Mat& grey() const;

  /// CV_8UC3 in the order Y, U, V. Throws InputError when the frame has no colour.
  const cv::Mat& yuv() const;

  /// Relation::observe() of these images; null when the relation has no observation. Who asks while another thread is
  /// at it makes it too, so that nobody waits; all are given the same one. The relation must outlive the images, which
  /// know it by its address.
  const Observation* observation(const Relation& relation) const;

 private:
  const Frame& frame_;
  mutable std::once_flag grey_once_, yuv_once_;
  mutable cv::Mat grey_, yuv_;
  mutable std::mutex observations_mutex_;
  mutable std::map<const Relation*, std::unique_ptr<Observation>> observations_;
};

}  // namespace gestalt
