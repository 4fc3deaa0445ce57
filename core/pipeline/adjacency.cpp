// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "gestalt/core/pipeline/surface_modelling.h"

namespace gestalt {

namespace {

constexpr int block = 8;  // pixels

/// Whether a block of pixels and all that they touch to the right and below are of one label: most of an image is.
bool is_uniform(const int* row, const int* below) {
  int differences = 0;
  for (int i = -1; i <= block; ++i) differences |= (row[i] ^ row[0]) | (below[i] ^ row[0]);
  return differences == 0;
}

/// The touching pixels of some rows, by pair of labels.
struct TouchingPixels {
  std::vector<Adjacency> adjacencies;

  /// Rows from first up to, but without, end, with what they touch below.
  void look_at(const Frame& frame, const cv::Mat_<int>& labels, int first, int end,
               const SurfaceModellingParams& params) {
    const int width = labels.cols, height = labels.rows;
    const auto touch = [&](int p, int q, int label_p, int label_q) {
      if (label_p > label_q) {
        std::swap(p, q);
        std::swap(label_p, label_q);
      }
      Adjacency& adjacency = of(label_p - 1, label_q - 1);
      adjacency.border_2d.push_back({p, q});
      if (are_close(frame, {p, q}, params.border_depth)) adjacency.border_3d.push_back({p, q});
    };
    for (int v = first; v < end; ++v) {
      const int* row = labels[v];
      const int* below = v + 1 < height ? labels[v + 1] : nullptr;
      const auto look_around = [&](int u) {
        const int own = row[u];
        if (own == 0) return;
        const int p = v * width + u;
        const auto look = [&](const int* line, int du, int q) {
          if (u + du < 0 || u + du >= width) return;
          if (const int other = line[u + du]; other != 0 && other != own) touch(p, q, own, other);
        };
        look(row, 1, p + 1);
        if (below) {
          look(below, -1, p + width - 1);
          look(below, 0, p + width);
          look(below, 1, p + width + 1);
        }
      };
      for (int u = 0; u < width;) {
        if (below && u > 0 && u + block < width && is_uniform(row + u, below + u)) {
          u += block;
          continue;
        }
        look_around(u++);
      }
    }
  }

  /// Adds those of rows that come next.
  void append(TouchingPixels more) {
    for (Adjacency& other : more.adjacencies) {
      Adjacency& own = of(other.a, other.b);
      if (own.border_2d.empty()) {
        own = std::move(other);
        continue;
      }
      own.border_2d.insert(own.border_2d.end(), other.border_2d.begin(), other.border_2d.end());
      own.border_3d.insert(own.border_3d.end(), other.border_3d.begin(), other.border_3d.end());
    }
  }

 private:
  /// Most pixels touch the one that the pixel before touched.
  Adjacency& of(int a, int b) {
    if (last_ < adjacencies.size() && adjacencies[last_].a == a && adjacencies[last_].b == b) return adjacencies[last_];
    const std::uint64_t key = (std::uint64_t(a) << 32) | std::uint32_t(b);
    const auto [entry, fresh] = index_.try_emplace(key, adjacencies.size());
    if (fresh) adjacencies.push_back({a, b, {}, {}});
    last_ = entry->second;
    return adjacencies[last_];
  }

  std::unordered_map<std::uint64_t, std::size_t> index_;
  std::size_t last_ = 0;
};

}  // namespace

bool are_close(const Frame& frame, const PixelPair& pair, double reach) {
  const double a = frame.depth(pair.a), b = frame.depth(pair.b), z = std::min(a, b);
  return std::abs(a - b) < reach * (frame.noise.at(z) + z / std::min(frame.camera.fx, frame.camera.fy));
}

std::vector<Adjacency> find_adjacencies(const Frame& frame, const cv::Mat_<int>& labels,
                                        const SurfaceModellingParams& params) {
  constexpr int bands = 16;  // for any number of threads
  std::vector<TouchingPixels> found(bands);
  tbb::parallel_for(0, bands, [&](int band) {
    const auto row = [&](int i) { return int(std::int64_t(labels.rows) * i / bands); };
    found[std::size_t(band)].look_at(frame, labels, row(band), row(band + 1), params);
  });
  for (std::size_t band = 1; band < found.size(); ++band) found.front().append(std::move(found[band]));
  std::vector<Adjacency> adjacencies = std::move(found.front().adjacencies);
  std::sort(adjacencies.begin(), adjacencies.end(),
            [](const Adjacency& x, const Adjacency& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });
  return adjacencies;
}

}  // namespace gestalt
