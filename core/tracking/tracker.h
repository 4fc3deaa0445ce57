// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <span>
#include <vector>

#include "gestalt/core/base/export.h"
#include "gestalt/core/objects/object_description.h"
#include "gestalt/core/scene/frame.h"

namespace gestalt {

struct TrackerParams {
  int keep = 15;           ///< frames for which the number of an object that is not seen is kept
  double overlap = 0.2;    ///< least intersection over union of two masks that are of one object by themselves
  double distance = 0.15;  ///< metres; farthest between the centroids of an object in two frames whose masks do not
                           ///< overlap so much
  double colour = 60;      ///< largest distance of their mean colours then, of 0 to 255 a channel
  double size = 0.5;       ///< least ratio of their areas then, the smaller to the larger
};

/// The numbers of a frame's objects, and what became of others. Numbers count from 1 and are never given twice.
struct FrameTracks {
  std::vector<int> numbers;   ///< of each object, in their order
  std::vector<int> appeared;  ///< given for the first time
  std::vector<int> hidden;    ///< not seen in this frame, but kept
  std::vector<int> lost;      ///< not kept any longer, from this frame on

  struct Change {
    int from;  ///< of the whole that has split, or of the part that has merged
    int into;  ///< of the part that is new, or of the whole
  };
  std::vector<Change> split;   ///< most of a new object was a part of an object that is seen, too
  std::vector<Change> merged;  ///< most of an object that was seen in the previous frame is now in another one
};

/// Gives objects the numbers that they had in earlier frames.
///
/// Points of each object as it was last seen are moved by the camera's motion, where poses are given, and projected:
/// those that fall into an object of this frame, and are not hidden, give the overlap of both masks. Pairs of an
/// earlier and a present object are taken in the order of their similarity: overlap first, then distance, colour and
/// size. The result is the same for equal calls.
class GESTALT_EXPORT Tracker {
 public:
  explicit Tracker(const TrackerParams& params = {}) : params_(params) {}

  /// The next frame: its image of labels, which may be of another size than the last one's, and the objects with these
  /// labels. pose: from the camera's frame to one that does not move; where this frame or the last one with the object
  /// has none, the camera is taken to stand still. Throws InputError when labels are not of the frame's size.
  FrameTracks update(const Frame& frame, const cv::Mat_<std::uint16_t>& labels,
                     std::span<const ObjectDescription> objects,
                     const std::optional<Eigen::Isometry3d>& pose = std::nullopt);

 private:
  /// An object as it was last seen.
  struct Track {
    int number;
    int unseen = 0;                       // frames since
    std::vector<Eigen::Vector3d> points;  // an even sample; camera frame of that time
    std::optional<Eigen::Isometry3d> pose;
    Eigen::Vector3d centroid;
    double area;  // square metres across the view
    std::optional<Colour> colour;
  };
  struct Overlaps;

  Track seen(int number, const Frame& frame, const cv::Mat_<std::uint16_t>& labels, const ObjectDescription& object,
             const std::optional<Eigen::Isometry3d>& pose) const;
  Overlaps overlaps(const Frame& frame, const cv::Mat_<std::uint16_t>& labels,
                    std::span<const ObjectDescription> objects, const std::optional<Eigen::Isometry3d>& pose) const;
  double similarity(const Track& track, const Track& present, double overlap) const;

  TrackerParams params_;
  int next_ = 1;
  std::vector<Track> tracks_;  // by number
};

}  // namespace gestalt
