// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <unordered_map>

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

}  // namespace

bool are_close(const Frame& frame, const PixelPair& pair, double reach) {
  const double a = frame.depth(pair.a), b = frame.depth(pair.b), z = std::min(a, b);
  return std::abs(a - b) < reach * (frame.noise.at(z) + z / std::min(frame.camera.fx, frame.camera.fy));
}

std::vector<Adjacency> find_adjacencies(const Frame& frame, const cv::Mat_<int>& labels,
                                        const SurfaceModellingParams& params) {
  std::vector<Adjacency> adjacencies;
  std::unordered_map<std::uint64_t, std::size_t> index;
  const int width = labels.cols, height = labels.rows;
  const auto touch = [&](int p, int q, int label_p, int label_q) {
    if (label_p > label_q) {
      std::swap(p, q);
      std::swap(label_p, label_q);
    }
    const std::uint64_t key = (std::uint64_t(label_p) << 32) | std::uint32_t(label_q);
    const auto [entry, fresh] = index.try_emplace(key, adjacencies.size());
    if (fresh) adjacencies.push_back({label_p - 1, label_q - 1, {}, {}});
    Adjacency& adjacency = adjacencies[entry->second];
    adjacency.border_2d.push_back({p, q});
    if (are_close(frame, {p, q}, params.border_depth)) adjacency.border_3d.push_back({p, q});
  };
  for (int v = 0; v < height; ++v) {
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
  std::sort(adjacencies.begin(), adjacencies.end(),
            [](const Adjacency& x, const Adjacency& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });
  return adjacencies;
}

}  // namespace gestalt
