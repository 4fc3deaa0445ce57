// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/point_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "gestalt/core/base/wide.h"

namespace gestalt {

namespace {

static_assert(PointBlocks::size == wide_lanes);

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Eight points, or the least or largest coordinates of eight boxes.
struct WidePoints {
  WideFloats x, y, z;
};

struct WideBoxes {
  WidePoints low, high;
};

constexpr std::ptrdiff_t lanes = wide_lanes;

GESTALT_INLINE void load(const float* from, WideFloats& to) { std::memcpy(&to, from, sizeof(to)); }

GESTALT_INLINE void load(const PointBlocks& points, int block, WidePoints& p) {
  const float* from = points.block(block);
  load(from, p.x);
  load(from + lanes, p.y);
  load(from + 2 * lanes, p.z);
}

/// The boxes of eight blocks.
GESTALT_INLINE void load(const PointBlocks& points, int first, WideBoxes& boxes) {
  const float* from = points.boxes(first / wide_lanes);
  load(from, boxes.low.x);
  load(from + lanes, boxes.high.x);
  load(from + 2 * lanes, boxes.low.y);
  load(from + 3 * lanes, boxes.high.y);
  load(from + 4 * lanes, boxes.low.z);
  load(from + 5 * lanes, boxes.high.z);
}

/// From each of eight points to one point of a block.
GESTALT_INLINE void square_distances(const WidePoints& p, const float* block, int lane, WideFloats& squared) {
  const WideFloats dx = p.x - block[lane], dy = p.y - block[wide_lanes + lane], dz = p.z - block[2 * wide_lanes + lane];
  squared = dx * dx + dy * dy + dz * dz;
}

/// One box, by its place among eight.
struct Box {
  Box(const PointBlocks& points, int block) {
    const float* of = points.boxes(block / wide_lanes) + block % wide_lanes;
    for (int i = 0; i < 3; ++i) low[i] = of[2 * i * lanes], high[i] = of[(2 * i + 1) * lanes];
  }
  float low[3], high[3];
};

GESTALT_INLINE void square_gap(const WideFloats& low, const WideFloats& high, float other_low, float other_high,
                               WideFloats& squared) {
  const WideFloats above = low - other_high, below = other_low - high, zero{};
  const WideFloats gap = above > below ? above : below;
  squared = gap > zero ? gap * gap : zero;
}

GESTALT_INLINE void square_reach(const WideFloats& low, const WideFloats& high, float other_low, float other_high,
                                 WideFloats& squared) {
  const WideFloats up = high - other_low, down = other_high - low, reach = up > down ? up : down;
  squared = reach * reach;
}

/// What squared distances of a point in a box and the points in eight others are at least. Rounding keeps the order of
/// numbers, so that it holds for rounded distances, too.
GESTALT_INLINE void bound_below(const PointBlocks& points, int first, const Box& box, WideFloats& bound) {
  WideBoxes boxes;
  load(points, first, boxes);
  WideFloats x, y, z;
  square_gap(boxes.low.x, boxes.high.x, box.low[0], box.high[0], x);
  square_gap(boxes.low.y, boxes.high.y, box.low[1], box.high[1], y);
  square_gap(boxes.low.z, boxes.high.z, box.low[2], box.high[2], z);
  bound = x + y + z;
}

/// What they are at most.
GESTALT_INLINE void bound_above(const PointBlocks& points, int first, const Box& box, WideFloats& bound) {
  WideBoxes boxes;
  load(points, first, boxes);
  WideFloats x, y, z;
  square_reach(boxes.low.x, boxes.high.x, box.low[0], box.high[0], x);
  square_reach(boxes.low.y, boxes.high.y, box.low[1], box.high[1], y);
  square_reach(boxes.low.z, boxes.high.z, box.low[2], box.high[2], z);
  bound = x + y + z;
}

GESTALT_INLINE float smallest_of(const WideFloats& x) {
  float smallest = x[0];
  for (int i = 1; i < wide_lanes; ++i) smallest = x[i] < smallest ? x[i] : smallest;
  return smallest;
}

GESTALT_INLINE float largest_of(const WideFloats& x) {
  float largest = x[0];
  for (int i = 1; i < wide_lanes; ++i) largest = x[i] > largest ? x[i] : largest;
  return largest;
}

/// Of the distances of two blocks, by point of the one the smallest to points of the other.
GESTALT_INLINE void smallest_distances(const WidePoints& p, const float* block, WideFloats& smallest) {
  square_distances(p, block, 0, smallest);
  for (int lane = 1; lane < wide_lanes; ++lane) {
    WideFloats squared;
    square_distances(p, block, lane, squared);
    smallest = squared < smallest ? squared : smallest;
  }
}

GESTALT_INLINE float smallest_distance(const PointBlocks& a, int block_a, const PointBlocks& b, int block_b) {
  WidePoints p;
  load(a, block_a, p);
  WideFloats squared;
  smallest_distances(p, b.block(block_b), squared);
  return smallest_of(squared);
}

GESTALT_WIDE float smallest_of_all(const PointBlocks& a, const PointBlocks& b) {
  // The pair of blocks whose boxes are nearest to each other rules most others out.
  int likeliest_a = 0, likeliest_b = 0;
  float least_bound = infinity;
  for (int i = 0; i < a.blocks(); ++i) {
    const Box box(a, i);
    for (int eight = 0; eight < b.blocks(); eight += wide_lanes) {
      WideFloats bound;
      bound_below(b, eight, box, bound);
      if (!(smallest_of(bound) < least_bound)) continue;
      for (int j = 0; j < wide_lanes; ++j)
        if (bound[j] < least_bound) least_bound = bound[j], likeliest_a = i, likeliest_b = eight + j;
    }
  }
  float smallest = smallest_distance(a, likeliest_a, b, likeliest_b);
  for (int i = 0; i < a.blocks(); ++i) {
    const Box box(a, i);
    for (int eight = 0; eight < b.blocks(); eight += wide_lanes) {
      WideFloats bound;
      bound_below(b, eight, box, bound);
      if (!(smallest_of(bound) < smallest)) continue;
      for (int j = 0; j < wide_lanes; ++j)
        if (bound[j] < smallest) smallest = std::min(smallest, smallest_distance(a, i, b, eight + j));
    }
  }
  return smallest;
}

GESTALT_WIDE float largest_of_all(const PointBlocks& a, const PointBlocks& b) {
  float largest = 0;
  for (int i = 0; i < a.blocks(); ++i) {
    WidePoints p;
    load(a, i, p);
    const Box box(a, i);
    for (int eight = 0; eight < b.blocks(); eight += wide_lanes) {
      WideFloats bound;
      bound_above(b, eight, box, bound);
      for (int j = 0; j < std::min(wide_lanes, b.blocks() - eight); ++j) {
        if (!(bound[j] > largest)) continue;
        WideFloats farthest{};
        for (int lane = 0; lane < wide_lanes; ++lane) {
          WideFloats squared;
          square_distances(p, b.block(eight + j), lane, squared);
          farthest = squared > farthest ? squared : farthest;
        }
        largest = std::max(largest, largest_of(farthest));
      }
    }
  }
  return largest;
}

/// Of each of eight points the nearest of others, the first of equals. bounds: room for as many as there are others'
/// blocks, a multiple of eight.
GESTALT_WIDE void find_nearest(const PointBlocks& from, int block, const PointBlocks& to, float* bounds,
                               float* squared_distances, float* nearest) {
  WidePoints p;
  load(from, block, p);
  const Box box(from, block);
  for (int eight = 0; eight < to.blocks(); eight += wide_lanes) {
    WideFloats bound;
    bound_below(to, eight, box, bound);
    std::memcpy(bounds + eight, &bound, sizeof(bound));
  }
  const int likeliest = int(std::min_element(bounds, bounds + to.blocks()) - bounds);
  WideFloats squared;
  smallest_distances(p, to.block(likeliest), squared);
  const float enough = largest_of(squared);
  WideFloats best{}, best_index{};
  best += infinity;
  for (int j = 0; j < to.blocks(); ++j) {
    if (bounds[j] > enough) continue;
    for (int lane = 0; lane < wide_lanes; ++lane) {
      square_distances(p, to.block(j), lane, squared);
      const WideFloats index = WideFloats{} + float(j * wide_lanes + lane);
      best_index = squared < best ? index : best_index;
      best = squared < best ? squared : best;
    }
  }
  std::memcpy(squared_distances, &best, sizeof(best));
  std::memcpy(nearest, &best_index, sizeof(best_index));
}

}  // namespace

PointBlocks::PointBlocks(const Eigen::Matrix3Xf& points) : count_(int(points.cols())) {
  const int blocks = (count_ + size - 1) / size;
  coordinates_.reserve(std::size_t(blocks) * 3 * size);
  boxes_.resize(std::size_t((blocks + size - 1) / size) * 6 * size);
  for (std::size_t i = 0; i < boxes_.size(); ++i) boxes_[i] = i / size % 2 == 0 ? infinity : -infinity;
  for (int i = 0; i < blocks; ++i)
    for (int coordinate = 0; coordinate < 3; ++coordinate) {
      float* box =
          boxes_.data() + std::ptrdiff_t{6} * size * (i / size) + std::ptrdiff_t{2} * size * coordinate + i % size;
      for (int lane = 0; lane < size; ++lane) {
        const float x = points(coordinate, std::min(i * size + lane, count_ - 1));
        coordinates_.push_back(x);
        box[0] = std::min(box[0], x);
        box[size] = std::max(box[size], x);
      }
    }
}

float smallest_squared_distance(const PointBlocks& a, const PointBlocks& b) { return smallest_of_all(a, b); }

float largest_squared_distance(const PointBlocks& a, const PointBlocks& b) { return largest_of_all(a, b); }

std::vector<NearestPoint> nearest_points(const PointBlocks& from, const PointBlocks& to, double share) {
  std::vector<NearestPoint> nearest;
  nearest.reserve(std::size_t(from.count()));
  std::vector<float> bounds(std::size_t(to.blocks() + wide_lanes));
  for (int block = 0; block < from.blocks(); ++block) {
    std::array<float, wide_lanes> squared, index;
    find_nearest(from, block, to, bounds.data(), squared.data(), index.data());
    for (int lane = 0; lane < std::min(wide_lanes, from.count() - block * wide_lanes); ++lane)
      nearest.push_back({squared[std::size_t(lane)], block * wide_lanes + lane, int(index[std::size_t(lane)])});
  }
  const auto kept = std::ptrdiff_t(std::ceil(share * double(nearest.size())));
  std::nth_element(
      nearest.begin(), nearest.begin() + kept - 1, nearest.end(), [](const NearestPoint& x, const NearestPoint& y) {
        return x.squared_distance != y.squared_distance ? x.squared_distance < y.squared_distance : x.from < y.from;
      });
  nearest.erase(nearest.begin() + kept, nearest.end());
  return nearest;
}

}  // namespace gestalt
