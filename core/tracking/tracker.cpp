// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/tracking/tracker.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "gestalt/core/base/error.h"

namespace gestalt {

namespace {

constexpr int most_samples = 1000;   // points of an object
constexpr double least_part = 0.5;   // of an object, which splits off or merges
constexpr double hiding_gap = 0.03;  // metres, by which what is seen is nearer than a point that it hides

/// From the camera's frame of then to that of now.
Eigen::Isometry3d motion(const std::optional<Eigen::Isometry3d>& then, const std::optional<Eigen::Isometry3d>& now) {
  if (!then || !now) return Eigen::Isometry3d::Identity();
  return now->inverse() * *then;
}

/// Area of a pixel at a depth, square metres.
double pixel_area(const Camera& camera, double depth) { return depth * depth / (camera.fx * camera.fy); }

}  // namespace

/// Of tracks (rows) with objects (columns).
struct Tracker::Overlaps {
  std::vector<std::vector<double>> of_track;   // shares of the track's points that fall into the object
  std::vector<std::vector<double>> of_object;  // share of the object's area that these points stand for
  std::vector<std::vector<double>> both;       // intersection over union
  std::vector<Eigen::Vector3d> centroids;      // of the tracks, in the camera frame of now
};

Tracker::Track Tracker::seen(int number, const Frame& frame, const cv::Mat_<std::uint16_t>& labels,
                             const ObjectDescription& object, const std::optional<Eigen::Isometry3d>& pose) const {
  Track track{number, 0, {}, pose, object.centroid, 0, object.colour};
  const cv::Rect box = object.box & cv::Rect(0, 0, labels.cols, labels.rows);
  const int step = object.pixels / most_samples + 1;
  int count = 0;
  for (int v = box.y; v < box.y + box.height; ++v)
    for (int u = box.x; u < box.x + box.width; ++u)
      if (const int pixel = v * frame.width() + u; labels(v, u) == object.label && frame.valid(pixel)) {
        track.area += pixel_area(frame.camera, double(frame.depth(v, u)));
        if (count++ % step == 0) track.points.push_back(frame.point(pixel).cast<double>());
      }
  return track;
}

Tracker::Overlaps Tracker::overlaps(const Frame& frame, const cv::Mat_<std::uint16_t>& labels,
                                    std::span<const ObjectDescription> objects,
                                    const std::optional<Eigen::Isometry3d>& pose) const {
  const Camera& camera = frame.camera;
  std::vector<int> column(65536, -1);
  std::vector<double> areas(objects.size(), 0);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    column[std::size_t(objects[i].label)] = int(i);
    areas[i] = objects[i].pixels * pixel_area(camera, objects[i].centroid.z());
  }
  const std::vector<std::vector<double>> zeros(tracks_.size(), std::vector<double>(objects.size(), 0));
  Overlaps overlaps{zeros, zeros, zeros, {}};
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    const Track& track = tracks_[t];
    const Eigen::Isometry3d moved = motion(track.pose, pose);
    overlaps.centroids.push_back(moved * track.centroid);
    for (const Eigen::Vector3d& then : track.points) {
      const Eigen::Vector3d p = moved * then;
      if (!(p.z() > 0)) continue;
      const double x = camera.fx * p.x() / p.z() + camera.cx, y = camera.fy * p.y() / p.z() + camera.cy;
      if (!(x > -0.5 && y > -0.5 && x < camera.width - 0.5 && y < camera.height - 0.5)) continue;
      const int u = int(std::lround(x)), v = int(std::lround(y));
      const int object = column[labels(v, u)];
      if (object < 0 || (frame.depth(v, u) > 0 && double(frame.depth(v, u)) < p.z() - hiding_gap)) continue;
      overlaps.of_track[t][std::size_t(object)] += 1.0 / double(track.points.size());
    }
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const double common = std::min(overlaps.of_track[t][i] * track.area, areas[i]);
      if (common <= 0) continue;
      overlaps.of_object[t][i] = common / areas[i];
      overlaps.both[t][i] = common / (track.area + areas[i] - common);
    }
  }
  return overlaps;
}

/// Overlap counts most, so that what stands still keeps its number beside what looks the same; 0: another object.
double Tracker::similarity(const Track& track, const Track& present, double overlap) const {
  const double distance = (track.centroid - present.centroid).norm();
  const double colour = track.colour && present.colour ? (track.colour->mean - present.colour->mean).norm() : 0;
  const double size = std::min(track.area, present.area) / std::max({track.area, present.area, 1e-12});
  // The longer something is not seen, the farther it may be.
  const double reach = params_.distance * std::sqrt(1.0 + track.unseen);
  if (overlap < params_.overlap && (distance > reach || colour > params_.colour || size < params_.size)) return 0;
  return overlap + 0.5 * std::exp(-distance / params_.distance) + 0.25 * std::exp(-colour / params_.colour) +
         0.25 * size;
}

FrameTracks Tracker::update(const Frame& frame, const cv::Mat_<std::uint16_t>& labels,
                            std::span<const ObjectDescription> objects, const std::optional<Eigen::Isometry3d>& pose) {
  if (labels.size() != frame.depth.size())
    throw InputError(frame.name + ": labels of " + std::to_string(labels.cols) + "x" + std::to_string(labels.rows) +
                     " pixels, but depth of " + std::to_string(frame.width()) + "x" + std::to_string(frame.height()));
  const Overlaps overlaps = this->overlaps(frame, labels, objects, pose);
  std::vector<Track> present;
  for (const ObjectDescription& object : objects) present.push_back(seen(0, frame, labels, object, pose));

  struct Pair {
    double similarity;
    std::size_t track, object;
  };
  std::vector<Pair> pairs;
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    Track moved = tracks_[t];
    moved.centroid = overlaps.centroids[t];
    for (std::size_t i = 0; i < objects.size(); ++i)
      if (const double s = similarity(moved, present[i], overlaps.both[t][i]); s > 0) pairs.push_back({s, t, i});
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& x, const Pair& y) { return x.similarity > y.similarity; });
  std::vector<int> object_of(tracks_.size(), -1);
  for (const Pair& pair : pairs)
    if (object_of[pair.track] < 0 && present[pair.object].number == 0) {
      object_of[pair.track] = int(pair.object);
      present[pair.object].number = tracks_[pair.track].number;
    }

  FrameTracks found;
  for (std::size_t i = 0; i < present.size(); ++i) {
    if (present[i].number == 0) {
      present[i].number = next_++;
      found.appeared.push_back(present[i].number);
      for (std::size_t t = 0; t < tracks_.size(); ++t)
        if (object_of[t] >= 0 && overlaps.of_object[t][i] > least_part)
          found.split.push_back({tracks_[t].number, present[i].number});
    }
    found.numbers.push_back(present[i].number);
  }
  std::vector<Track> kept = present;
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    if (object_of[t] >= 0) continue;
    Track track = std::move(tracks_[t]);
    if (track.unseen == 0)
      for (std::size_t i = 0; i < present.size(); ++i)
        if (overlaps.of_track[t][i] > least_part) found.merged.push_back({track.number, present[i].number});
    if (++track.unseen > params_.keep) {
      found.lost.push_back(track.number);
    } else {
      found.hidden.push_back(track.number);
      kept.push_back(std::move(track));
    }
  }
  std::sort(kept.begin(), kept.end(), [](const Track& x, const Track& y) { return x.number < y.number; });
  tracks_ = std::move(kept);
  return found;
}

}  // namespace gestalt
