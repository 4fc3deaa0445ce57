// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <opencv2/core.hpp>

#include "gestalt/core/scene/frame.h"

namespace gestalt {

class Images;

/// What is made of a frame's images alone, before there are surfaces.
class GESTALT_EXPORT Observation {
 public:
  virtual ~Observation();
};

/// Makes an observation.
class GESTALT_EXPORT Observer {
 public:
  virtual ~Observer();

  /// Work on images that needs no surfaces, such as filtering: done while the levels below leave threads idle, and
  /// handed over by Scene::observed(). Null, as by default, when there is none. Const and thread-safe.
  virtual std::unique_ptr<Observation> observe(const Images& images) const;
};

/// A frame's images, and what is derived from them alone. Each is made once, when it is first used. Thread-safe, except
/// for forget_observations().
class GESTALT_EXPORT Images {
 public:
  explicit Images(Frame frame);
  ~Images();
  Images(const Images&) = delete;
  Images& operator=(const Images&) = delete;

  const Frame& frame() const { return frame_; }

  /// CV_8UC1. Throws InputError when the frame has no colour.
  const cv::Mat& grey() const;

  /// CV_8UC3 in the order Y, U, V. Throws InputError when the frame has no colour.
  const cv::Mat& yuv() const;

  /// Observer::observe() of these images, made once; null when there is none. A thread that asks while another is at
  /// work makes it too, so that none waits; all get the same one. The observer must outlive the images, which know it
  /// by its address.
  const Observation* observation(const Observer& observer) const;

  /// Frees what was observed, most of the memory. Not while another thread uses an observation.
  void forget_observations();

 private:
  const Frame frame_;
  mutable std::once_flag grey_once_, yuv_once_;
  mutable cv::Mat grey_, yuv_;
  mutable std::mutex observations_mutex_;
  mutable std::map<const Observer*, std::unique_ptr<Observation>> observations_;
};

}  // namespace gestalt
