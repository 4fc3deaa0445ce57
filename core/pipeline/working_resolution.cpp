// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "working_resolution.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "gestalt/core/pipeline/surface_modelling.h"

namespace gestalt {

namespace {

constexpr float one_side = 0.015F;    // of the depth: pixels of a block that differ by more are of two surfaces
constexpr float colour_scale = 25;    // difference of a channel that counts as much as one step of depth
constexpr float distance_weight = 1;  // of a block's width in the image

cv::Size reduced_size(cv::Size size, int factor) {
  return {(size.width + factor - 1) / factor, (size.height + factor - 1) / factor};
}

/// Calls f with the row-major index of each pixel of a block.
template <class F>
void for_block(cv::Size size, int factor, int u, int v, const F& f) {
  for (int y = v * factor; y < std::min((v + 1) * factor, size.height); ++y)
    for (int x = u * factor; x < std::min((u + 1) * factor, size.width); ++x) f(y * size.width + x);
}

Camera reduced_camera(const Camera& camera, int factor) {
  const cv::Size size = reduced_size({camera.width, camera.height}, factor);
  const auto centre = [factor](double c, int pixels) {
    return std::clamp((c + 0.5) / factor - 0.5, 0.0, double(pixels));
  };
  return {size.width,
          size.height,
          camera.fx / factor,
          camera.fy / factor,
          centre(camera.cx, size.width),
          centre(camera.cy, size.height)};
}

/// What was found in a reduced frame, and for each pixel of the whole one where it belongs.
class Enlargement {
 public:
  Enlargement(const Scene& found, const Frame& frame, int factor)
      : found_(found),
        small_(found.frame()),
        frame_(frame),
        factor_(factor),
        patches_{cv::Mat_<int>(frame.depth.size(), 0), cv::Mat_<cv::Vec3f>(frame.depth.size(), cv::Vec3f(0, 0, 0)),
                 found.patches().count, found.patches().cut_from},
        labels_(frame.depth.size(), 0) {
    tbb::parallel_for(0, small_.height(), [&](int v) {
      for (int u = 0; u < small_.width(); ++u) fill(u, v);
    });
  }

  std::shared_ptr<const Scene> scene(const SurfaceModellingParams& params) {
    SurfaceSet set;
    for (const Surface& surface : found_.surfaces().surfaces) {
      set.surfaces.push_back({{}, surface.model, surface.refusals});
      set.surfaces.back().pixels.reserve(surface.pixels.size() * std::size_t(factor_ * factor_));
    }
    for (int pixel = 0; pixel < int(labels_.total()); ++pixel)
      if (const int label = labels_(pixel); label > 0) set.surfaces[std::size_t(label) - 1].pixels.push_back(pixel);
    Frame frame = frame_;
    frame.noise = small_.noise;
    frame.deadline = small_.deadline;
    set.adjacencies = find_adjacencies(frame, labels_, params);
    set.labels = std::move(labels_);
    return std::make_shared<const Scene>(std::move(frame), std::move(patches_), std::move(set));
  }

 private:
  int surface_at(int block) const { return found_.surfaces().labels.ptr<int>()[block]; }

  /// Whether a block is within one surface.
  bool is_inside(int u, int v) const {
    if (u == 0 || v == 0 || u + 1 == small_.width() || v + 1 == small_.height()) return false;
    const cv::Mat_<int>& labels = found_.surfaces().labels;
    int differences = 0;
    for (int dv = -1; dv <= 1; ++dv)
      for (int du = -1; du <= 1; ++du) differences |= labels(v + dv, u + du) ^ labels(v, u);
    return differences == 0;
  }

  void put(int pixel, int block) {
    labels_.ptr<int>()[pixel] = surface_at(block);
    patches_.labels.ptr<int>()[pixel] = found_.patches().labels.ptr<int>()[block];
    patches_.normals.ptr<cv::Vec3f>()[pixel] = found_.patches().normals.ptr<cv::Vec3f>()[block];
  }

  void fill(int u, int v) {
    const int block = v * small_.width() + u;
    const bool inside = is_inside(u, v);
    if (inside && surface_at(block) == 0) return;
    for_block(frame_.depth.size(), factor_, u, v, [&](int pixel) {
      if (!frame_.valid(pixel)) return;
      if (inside)
        put(pixel, block);
      else if (const int source = source_of(pixel, u, v); source >= 0)
        put(pixel, source);
    });
    if (!inside && surface_at(block) != 0) put(most_alike(u, v), block);
  }

  /// The block that a pixel belongs to; -1 where none around it has a surface.
  int source_of(int pixel, int u, int v) const {
    int best = -1;
    float least = std::numeric_limits<float>::infinity();
    for (int y = std::max(0, v - 1); y <= std::min(small_.height() - 1, v + 1); ++y)
      for (int x = std::max(0, u - 1); x <= std::min(small_.width() - 1, u + 1); ++x) {
        const int block = y * small_.width() + x;
        if (surface_at(block) == 0) continue;
        const float d = difference(pixel, block, x, y);
        if (d < least) least = d, best = block;
      }
    return best;
  }

  float difference(int pixel, int block, int u, int v) const {
    const Eigen::Vector3f p = frame_.point(pixel), away = p - small_.point(block);
    const cv::Vec3f& n = found_.patches().normals.ptr<cv::Vec3f>()[block];
    const Eigen::Vector3f normal(n[0], n[1], n[2]);
    const float depth = normal.isZero() ? away.z() : normal.dot(away);
    const float step = float(small_.noise.at(double(p.z()))) + p.z() / float(small_.camera.fx);
    // A tangent plane goes on beyond its surface: what is far away in depth is not of it, however near the plane is.
    const float along = std::max(0.F, std::abs(away.z()) / step - 4);
    const float width = float(frame_.width());
    const float row = std::floor(float(pixel) / width), column = float(pixel % frame_.width());
    const float du = (column + 0.5F) / float(factor_) - float(u) - 0.5F,
                dv = (row + 0.5F) / float(factor_) - float(v) - 0.5F;
    float sum = depth * depth / (step * step) + along * along + distance_weight * (du * du + dv * dv);
    if (frame_.has_colour()) {
      const cv::Vec3b &a = frame_.colour.ptr<cv::Vec3b>()[pixel], &b = small_.colour.ptr<cv::Vec3b>()[block];
      for (int i = 0; i < 3; ++i) {
        const float d = float(int(a[i]) - int(b[i])) / colour_scale;
        sum += d * d / 3;
      }
    }
    return sum;
  }

  /// The pixel of a block that is always its own, so that no surface is left without any.
  int most_alike(int u, int v) const {
    int most_alike = v * factor_ * frame_.width() + u * factor_;
    float least = std::numeric_limits<float>::infinity();
    for_block(frame_.depth.size(), factor_, u, v, [&](int pixel) {
      if (!frame_.valid(pixel)) return;
      const float d = difference(pixel, v * small_.width() + u, u, v);
      if (d < least) least = d, most_alike = pixel;
    });
    return most_alike;
  }

  const Scene& found_;
  const Frame& small_;
  const Frame& frame_;
  const int factor_;
  PatchMap patches_;
  cv::Mat_<int> labels_;
};

}  // namespace

int reduction(cv::Size size, int most_pixels) {
  int factor = 1;
  while (most_pixels > 0 && reduced_size(size, factor).area() > most_pixels) ++factor;
  return factor;
}

Frame reduced(const Frame& frame, int factor) {
  const cv::Size size = reduced_size(frame.depth.size(), factor);
  cv::Mat_<float> depth(size, 0.F);
  cv::Mat_<cv::Vec3b> colour;
  if (frame.has_colour()) colour.create(size);
  tbb::parallel_for(0, size.height, [&](int v) {
    std::vector<float> depths;
    for (int u = 0; u < size.width; ++u) {
      depths.clear();
      for_block(frame.depth.size(), factor, u, v, [&](int pixel) {
        if (frame.valid(pixel)) depths.push_back(frame.depth.ptr<float>()[pixel]);
      });
      float median = 0;
      if (!depths.empty()) {
        const auto middle = depths.begin() + std::ptrdiff_t((depths.size() - 1) / 2);
        std::nth_element(depths.begin(), middle, depths.end());
        median = *middle;
      }
      float sum = 0;
      cv::Vec3i colours(0, 0, 0);
      int count = 0;
      for_block(frame.depth.size(), factor, u, v, [&](int pixel) {
        const float z = frame.depth.ptr<float>()[pixel];
        if (!(std::abs(z - median) <= one_side * median)) return;
        sum += z;
        ++count;
        if (!colour.empty()) colours += cv::Vec3i(frame.colour.ptr<cv::Vec3b>()[pixel]);
      });
      depth(v, u) = sum / float(count);
      if (!colour.empty())
        for (int i = 0; i < 3; ++i) colour(v, u)[i] = std::uint8_t((2 * colours[i] + count) / (2 * count));
    }
  });
  Frame result = make_frame(frame.name, std::move(colour), std::move(depth), reduced_camera(frame.camera, factor));
  result.deadline = frame.deadline;
  return result;
}

std::shared_ptr<const Scene> enlarged(const Scene& found, const Frame& frame, int factor,
                                      const SurfaceModellingParams& params) {
  return Enlargement(found, frame, factor).scene(params);
}

}  // namespace gestalt
