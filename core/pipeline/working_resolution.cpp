// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "working_resolution.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <span>
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

/// A depth from which the pixels of a block that are of its larger side differ by no more than one_side; 0 where no
/// pixel has depth. `depths` is room to work in.
float depth_of_side(const Frame& frame, int factor, int u, int v, std::vector<float>& depths) {
  depths.clear();
  float nearest = std::numeric_limits<float>::infinity(), farthest = 0;
  for_block(frame.depth.size(), factor, u, v, [&](int pixel) {
    if (!frame.valid(pixel)) return;
    const float z = frame.depth.ptr<float>()[pixel];
    nearest = std::min(nearest, z);
    farthest = std::max(farthest, z);
    depths.push_back(z);
  });
  if (depths.empty()) return 0;
  if (farthest - nearest <= one_side * nearest) return nearest;  // all are of one side, most often
  const auto middle = depths.begin() + std::ptrdiff_t((depths.size() - 1) / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  return *middle;
}

/// What two values of a channel of colour add to a difference, by how far they are apart.
std::array<float, 256> channel_differences() {
  std::array<float, 256> differences;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const float d = float(i) / colour_scale;
    differences[i] = d * d / 3;
  }
  return differences;
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

  /// A block that a pixel may belong to.
  struct Candidate {
    int block;
    float u, v;
    Eigen::Vector3f point, normal;
    bool has_normal;
    cv::Vec3b colour;
  };

  /// The blocks around one that have a surface, row by row.
  struct Candidates {
    std::array<Candidate, 9> all;
    std::size_t count = 0;
    std::span<const Candidate> span() const { return {all.data(), count}; }
  };

  Candidate candidate(int u, int v) const {
    const int block = v * small_.width() + u;
    const cv::Vec3f& n = found_.patches().normals.ptr<cv::Vec3f>()[block];
    const Eigen::Vector3f normal(n[0], n[1], n[2]);
    const cv::Vec3b colour = frame_.has_colour() ? small_.colour.ptr<cv::Vec3b>()[block] : cv::Vec3b(0, 0, 0);
    return {block, float(u), float(v), small_.point(block), normal, !normal.isZero(), colour};
  }

  Candidates candidates_around(int u, int v) const {
    Candidates candidates;
    for (int y = std::max(0, v - 1); y <= std::min(small_.height() - 1, v + 1); ++y)
      for (int x = std::max(0, u - 1); x <= std::min(small_.width() - 1, u + 1); ++x)
        if (surface_at(y * small_.width() + x) != 0) candidates.all[candidates.count++] = candidate(x, y);
    return candidates;
  }

  void fill(int u, int v) {
    const int block = v * small_.width() + u;
    const bool inside = is_inside(u, v);
    if (inside) {
      if (surface_at(block) == 0) return;
      for_block(frame_.depth.size(), factor_, u, v, [&](int pixel) {
        if (frame_.valid(pixel)) put(pixel, block);
      });
      return;
    }
    const Candidates candidates = candidates_around(u, v);
    if (candidates.count == 0) return;
    for_block(frame_.depth.size(), factor_, u, v, [&](int pixel) {
      if (frame_.valid(pixel)) put(pixel, most_alike(pixel, candidates.span()));
    });
    if (surface_at(block) != 0) put(most_alike_of(u, v), block);
  }

  /// The block that a pixel belongs to.
  int most_alike(int pixel, std::span<const Candidate> candidates) const {
    const PixelDifference difference(*this, pixel);
    int best = candidates.front().block;
    float least = std::numeric_limits<float>::infinity();
    for (const Candidate& candidate : candidates) {
      const float d = difference(candidate, least);
      if (d < least) least = d, best = candidate.block;
    }
    return best;
  }

  /// How little a pixel is like a block: a square distance in depth, image and colour.
  class PixelDifference {
    static int row_of(const Frame& frame, int pixel) { return pixel / frame.width(); }

   public:
    PixelDifference(const Enlargement& enlargement, int pixel)
        : point_(enlargement.frame_.point(pixel)),
          step_(float(enlargement.small_.noise.at(double(point_.z()))) +
                point_.z() / float(enlargement.small_.camera.fx)),
          u_((float(pixel % enlargement.frame_.width()) + 0.5F) / float(enlargement.factor_)),
          v_((float(row_of(enlargement.frame_, pixel)) + 0.5F) / float(enlargement.factor_)),
          colour_(enlargement.frame_.has_colour() ? enlargement.frame_.colour.ptr<cv::Vec3b>()[pixel]
                                                  : cv::Vec3b(0, 0, 0)),
          channel_differences_(enlargement.channel_differences_) {}

    /// Not more exact than that it is at least `enough` where it is.
    float operator()(const Candidate& candidate, float enough) const {
      const Eigen::Vector3f away = point_ - candidate.point;
      const float depth = candidate.has_normal ? candidate.normal.dot(away) : away.z();
      // A tangent plane goes on beyond its surface: what is far away in depth is not of it, however near the plane is.
      const float along = std::max(0.F, std::abs(away.z()) / step_ - 4);
      const float du = u_ - candidate.u - 0.5F, dv = v_ - candidate.v - 0.5F;
      float sum = depth * depth / (step_ * step_) + along * along + distance_weight * (du * du + dv * dv);
      if (sum >= enough) return sum;
      for (int i = 0; i < 3; ++i)
        sum += channel_differences_[std::size_t(std::abs(int(colour_[i]) - int(candidate.colour[i])))];
      return sum;
    }

   private:
    Eigen::Vector3f point_;
    float step_, u_, v_;
    cv::Vec3b colour_;
    const std::array<float, 256>& channel_differences_;
  };

  /// The pixel of a block that is always its own, so that no surface is left without any.
  int most_alike_of(int u, int v) const {
    const Candidate own = candidate(u, v);
    int most_alike = v * factor_ * frame_.width() + u * factor_;
    float least = std::numeric_limits<float>::infinity();
    for_block(frame_.depth.size(), factor_, u, v, [&](int pixel) {
      if (!frame_.valid(pixel)) return;
      const float d = PixelDifference(*this, pixel)(own, least);
      if (d < least) least = d, most_alike = pixel;
    });
    return most_alike;
  }

  const Scene& found_;
  const Frame& small_;
  const Frame& frame_;
  const int factor_;
  const std::array<float, 256> channel_differences_ = channel_differences();
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
      const float side = depth_of_side(frame, factor, u, v, depths);
      float sum = 0;
      cv::Vec3i colours(0, 0, 0);
      int count = 0;
      for_block(frame.depth.size(), factor, u, v, [&](int pixel) {
        const float z = frame.depth.ptr<float>()[pixel];
        if (!(std::abs(z - side) <= one_side * side)) return;
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
