// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "level_selection.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "gestalt/core/scene/moments.h"
#include "patch_refinement.h"

namespace gestalt {

namespace {

constexpr double certain_distance = 3;  // sigma(z)
constexpr int outline = 1;              // px of the coarse level

struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double offset = 0;

  double distance(const Eigen::Vector3f& p) const { return std::abs(normal.dot(p.cast<double>()) + offset); }
};

/// Least-squares planes of the patches by label.
std::vector<Plane> fit_planes(const PyramidLevel& level) {
  std::vector<Moments> moments(std::size_t(level.patches.count) + 1);
  for (int pixel = 0; pixel < int(level.patches.labels.total()); ++pixel) {
    const int label = level.patches.labels.ptr<int>()[pixel];
    if (label == 0) continue;
    moments[std::size_t(label)].add(level.frame.point(pixel).cast<double>());
  }
  std::vector<Plane> planes(moments.size());
  for (std::size_t i = 1; i < moments.size(); ++i) {
    const Moments& m = moments[i];
    if (m.weight == 0) continue;
    planes[i].normal = m.normal();
    planes[i].offset = -planes[i].normal.dot(m.mean());
  }
  return planes;
}

class Selection {
 public:
  Selection(const PyramidLevel& coarse, const PyramidLevel& fine, const SelectionParams& params)
      : coarse_(coarse),
        fine_(fine),
        params_(params),
        coarse_planes_(fit_planes(coarse)),
        fine_planes_(fit_planes(fine)) {}

  LabelledPatches select() {
    count_points();
    decide();
    return label_fine_pixels();
  }

 private:
  /// What a patch explains of the points under a coarse patch.
  struct Explained {
    double points = 0;
    double error = 0;  // sum of 1 - p(f_i | H)
  };

  /// The coarse patch over a pixel of the fine level; 0 = none.
  int over(int u, int v) const {
    const int label = coarse_.patches.labels(v / 2, u / 2);
    if (label == 0) return 0;
    const float z = fine_.frame.depth(v, u);
    // The coarse pixel may show the other side of a depth jump.
    return z > 0 && std::abs(z - coarse_.frame.depth(v / 2, u / 2)) <= fine_.tolerances.distance(z) ? label : 0;
  }

  double error(const Plane& plane, const Eigen::Vector3f& p) const {
    const double e = plane.distance(p) / (params_.error_noise * fine_.frame.noise.at(double(p.z())));
    return 1 - std::exp(-e * e);
  }

  void count_points() {
    by_coarse_.resize(coarse_planes_.size());
    std::pair<int, int> pair{0, 0};
    Explained* part = nullptr;
    for (int v = 0; v < fine_.frame.height(); ++v)
      for (int u = 0; u < fine_.frame.width(); ++u) {
        const int coarse = over(u, v);
        if (coarse == 0) continue;
        const Eigen::Vector3f p = fine_.frame.point(v * fine_.frame.width() + u);
        Explained& whole = by_coarse_[std::size_t(coarse)];
        whole.points += 1;
        whole.error += error(coarse_planes_[std::size_t(coarse)], p);
        const int fine = fine_.patches.labels(v, u);
        if (fine == 0) continue;
        if (std::pair(coarse, fine) != pair) {  // neighbouring pixels are mostly of the same two
          pair = {coarse, fine};
          part = &by_pair_[pair];
        }
        part->points += 1;
        part->error += error(fine_planes_[std::size_t(fine)], p);
      }
  }

  /// Eq. 3 times A_m, in points: a patch costs kappa_1 of the points under the coarse patch.
  double savings(const Explained& explained, double normalisation) const {
    return explained.points - params_.kappa_1 * normalisation - params_.kappa_2 * explained.error;
  }

  /// Eq. 4.
  void decide() {
    std::vector<double> fine_savings(by_coarse_.size(), 0.0);
    for (const auto& [pair, part] : by_pair_)
      fine_savings[std::size_t(pair.first)] += std::max(0.0, savings(part, by_coarse_[std::size_t(pair.first)].points));
    kept_.assign(by_coarse_.size(), false);
    for (std::size_t c = 1; c < kept_.size(); ++c)
      kept_[c] = !(savings(by_coarse_[c], by_coarse_[c].points) < fine_savings[c]);
  }

  bool at_outline(int u, int v) const {
    const cv::Mat_<int>& labels = coarse_.patches.labels;
    for (int y = std::max(0, v / 2 - outline); y <= std::min(labels.rows - 1, v / 2 + outline); ++y)
      for (int x = std::max(0, u / 2 - outline); x <= std::min(labels.cols - 1, u / 2 + outline); ++x)
        if (labels(y, x) != labels(v / 2, u / 2)) return true;
    return false;
  }

  /// Whether a fine pixel is of the coarse patch over it without a doubt: away from its outline, and as near to its
  /// plane as noise lets points be.
  bool certain(int coarse, int u, int v) const {
    const Eigen::Vector3f p = fine_.frame.point(v * fine_.frame.width() + u);
    return !at_outline(u, v) &&
           coarse_planes_[std::size_t(coarse)].distance(p) <= certain_distance * fine_.frame.noise.at(double(p.z()));
  }

  /// Kept coarse patches first, then the fine ones.
  LabelledPatches label_fine_pixels() const {
    LabelledPatches result{cv::Mat_<int>(fine_.frame.depth.size(), 0), coarse_.patches.count + fine_.patches.count};
    tbb::parallel_for(0, result.labels.rows, [&](int v) {
      for (int u = 0; u < result.labels.cols; ++u) {
        const int coarse = over(u, v), fine = fine_.patches.labels(v, u);
        if (coarse != 0 && kept_[std::size_t(coarse)]) {
          if (certain(coarse, u, v)) result.labels(v, u) = coarse;
        } else if (fine != 0) {
          result.labels(v, u) = coarse_.patches.count + fine;
        }
      }
    });
    return result;
  }

  const PyramidLevel& coarse_;
  const PyramidLevel& fine_;
  const SelectionParams& params_;
  const std::vector<Plane> coarse_planes_, fine_planes_;
  std::vector<Explained> by_coarse_;
  std::map<std::pair<int, int>, Explained> by_pair_;
  std::vector<bool> kept_;
};

}  // namespace

LabelledPatches select_patches(const PyramidLevel& coarse, const PyramidLevel& fine, const SelectionParams& params) {
  return tidy_outlines(fine.frame, fine.normals, fine.tolerances, Selection(coarse, fine, params).select());
}

}  // namespace gestalt
