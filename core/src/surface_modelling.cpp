// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/surface_modelling.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "gestalt/error.h"

namespace gestalt {

namespace {

/// A patch on its way to a surface.
struct Candidate {
  std::vector<int> pixels;
  std::vector<Eigen::Vector3f> points;  // parallel to pixels
  std::shared_ptr<const SurfaceModel> model;
  std::size_t fitter = 0;
  double error = 0;  // S_err of Eq. 2, in points
};

/// A surface that explains two patches together, and what it saves over two (Eq. 8).
struct Merger {
  std::shared_ptr<const SurfaceModel> model;
  std::size_t fitter = 0;
  double error = 0;
  double gain = 0;
};

class SurfaceModeller {
 public:
  SurfaceModeller(const std::vector<std::shared_ptr<const Fitter>>& fitters, const SurfaceModellingParams& params)
      : fitters_(fitters), params_(params) {}

  /// Chooses the fitter with the largest savings.
  void choose_model(Candidate& patch) const {
    double best = 0;
    for (std::size_t f = 0; f < fitters_.size(); ++f) {
      if (f > 0 && int(patch.points.size()) > params_.largest_patch) break;
      const auto model = fitters_[f]->fit(patch.points);
      if (!model) continue;
      const double error = error_of(*model, patch.points);
      const double savings = -cost(f) - params_.kappa_2 * error / double(patch.points.size());
      if (patch.model && savings <= best) continue;
      best = savings;
      patch.model = model;
      patch.fitter = f;
      patch.error = error;
    }
    if (!patch.model)
      throw PluginError("primitive level: no fitter could model a patch of " + std::to_string(patch.points.size()) +
                        " points; put a fitter that takes any patch first in primitive.fitters");
  }

  /// The best single surface for two patches. gain > 0 when it is a better description than the two (Eq. 8). A_m is the
  /// size of the smaller patch: normalised by the merged size, a table would swallow every small patch beside it, for
  /// however badly it explains that patch, the share of its points in the whole is small.
  Merger merge(const Candidate& a, const Candidate& b) const {
    const auto size = a.points.size() + b.points.size();
    const auto normalisation = double(std::min(a.points.size(), b.points.size()));
    const double apart = cost(a.fitter) + cost(b.fitter) + params_.kappa_2 * (a.error + b.error) / normalisation;
    Merger best;
    best.gain = -std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < fitters_.size(); ++f) {
      if (f > 0 && int(size) > params_.largest_patch) break;
      const auto model = a.fitter == f && b.fitter == f
                             ? fitters_[f]->fit_merged(*a.model, a.points, *b.model, b.points)
                             : fit_joined(*fitters_[f], a, b);
      if (!model) continue;
      const double error = error_of(*model, a.points) + error_of(*model, b.points);
      const double gain = apart - cost(f) - params_.kappa_2 * error / normalisation;
      if (gain > best.gain) best = {model, f, error, gain};
    }
    return best;
  }

 private:
  double cost(std::size_t fitter) const { return params_.kappa_1 * fitters_[fitter]->parameter_count(); }

  static std::shared_ptr<const SurfaceModel> fit_joined(const Fitter& fitter, const Candidate& a, const Candidate& b) {
    std::vector<Eigen::Vector3f> points = a.points;
    points.insert(points.end(), b.points.begin(), b.points.end());
    return fitter.fit(points);
  }

  /// S_err of Eq. 2, from an even sample of a large patch.
  double error_of(const SurfaceModel& model, const std::vector<Eigen::Vector3f>& points) const {
    const std::size_t step = (points.size() + error_samples - 1) / error_samples;
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.size(); i += step, ++count) {
      const double z = points[i].z();
      const double sigma = params_.sigma + params_.sigma_z * z * z;
      sum += 1 - std::exp(-double(model.squared_distance(points[i])) / (sigma * sigma));
    }
    return sum * double(points.size()) / double(count);
  }

  static constexpr std::size_t error_samples = 1000;
  const std::vector<std::shared_ptr<const Fitter>>& fitters_;
  const SurfaceModellingParams& params_;
};

std::vector<Candidate> gather(const Frame& frame, const PatchMap& patches) {
  std::vector<Candidate> candidates(std::size_t(patches.count));
  for (int pixel = 0; pixel < int(patches.labels.total()); ++pixel)
    if (const int label = patches.labels.ptr<int>()[pixel]; label > 0) {
      candidates[std::size_t(label) - 1].pixels.push_back(pixel);
      candidates[std::size_t(label) - 1].points.push_back(frame.point(pixel));
    }
  return candidates;
}

/// Pairs of patches with a touching pixel pair that is close in depth.
std::set<std::pair<int, int>> neighbours_3d(const Frame& frame, const std::vector<Adjacency>& adjacencies,
                                            const SurfaceModellingParams& params) {
  std::set<std::pair<int, int>> neighbours;
  for (const Adjacency& adjacency : adjacencies)
    for (const PixelPair& pair : adjacency.border_2d)
      if (std::abs(frame.depth.ptr<float>()[pair.a] - frame.depth.ptr<float>()[pair.b]) < params.neighbour_depth) {
        neighbours.emplace(adjacency.a, adjacency.b);
        break;
      }
  return neighbours;
}

/// Joins b into a.
void absorb(Candidate& a, Candidate& b, const Merger& merger) {
  a.pixels.insert(a.pixels.end(), b.pixels.begin(), b.pixels.end());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  a.model = merger.model;
  a.fitter = merger.fitter;
  a.error = merger.error;
  b = {};
}

/// Greedy surface merging (Algorithm 1), best gain first; ties go to the pair with the smaller numbers.
void merge_greedily(std::vector<Candidate>& candidates, const std::set<std::pair<int, int>>& neighbours,
                    const SurfaceModeller& modeller) {
  std::vector<std::pair<int, int>> pairs(neighbours.begin(), neighbours.end());
  std::vector<Merger> first(pairs.size());
  tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
    first[i] = modeller.merge(candidates[std::size_t(pairs[i].first)], candidates[std::size_t(pairs[i].second)]);
  });
  std::map<std::pair<int, int>, Merger> mergers;
  for (std::size_t i = 0; i < pairs.size(); ++i) mergers.emplace(pairs[i], std::move(first[i]));

  while (!mergers.empty()) {
    const auto best = std::max_element(mergers.begin(), mergers.end(), [](const auto& x, const auto& y) {
      return x.second.gain < y.second.gain;  // max_element keeps the first of equals
    });
    if (!(best->second.gain > 0)) return;
    const auto [kept, gone] = best->first;
    absorb(candidates[std::size_t(kept)], candidates[std::size_t(gone)], best->second);

    std::set<int> around;
    for (auto entry = mergers.begin(); entry != mergers.end();) {
      const auto [a, b] = entry->first;
      const bool touched = a == kept || b == kept || a == gone || b == gone;
      if (touched)
        for (const int node : {a, b})
          if (node != kept && node != gone) around.insert(node);
      entry = touched ? mergers.erase(entry) : std::next(entry);
    }
    for (const int other : around)
      mergers.emplace(std::minmax(kept, other),
                      modeller.merge(candidates[std::size_t(kept)], candidates[std::size_t(other)]));
  }
}

}  // namespace

const Parameters<SurfaceModellingParams>& SurfaceModellingParams::parameters() {
  using P = SurfaceModellingParams;
  static const auto parameters =
      Parameters<P>()
          .real("sigma", &P::sigma, 1e-5, 1, "m", "scale of the error model, p(f | H) = exp(-e^2 / sigma(z)^2)")
          .real("sigma_z", &P::sigma_z, 0, 1, "1/m", "growth of the scale: sigma(z) = sigma + sigma_z z^2")
          .real("kappa_1", &P::kappa_1, 0, 100, "", "weight of the number of parameters (Eq. 3)")
          .real("kappa_2", &P::kappa_2, 0, 100, "", "weight of the error (Eq. 3)")
          .integer("largest_patch", &P::largest_patch, 1, 100000000, "px",
                   "a larger patch is only modelled by the first fitter")
          .real("neighbour_depth", &P::neighbour_depth, 0, 10, "m",
                "touching pixels closer in depth than this make their patches candidates for merging")
          .real("border_depth_per_metre", &P::border_depth_per_metre, 0, 1, "",
                "touching pixels with |dz| < this * z are 3D border");
  return parameters;
}

SurfaceSet model_surfaces(const Frame& frame, const PatchMap& patches,
                          const std::vector<std::shared_ptr<const Fitter>>& fitters,
                          const SurfaceModellingParams& params) {
  const SurfaceModeller modeller(fitters, params);
  std::vector<Candidate> candidates = gather(frame, patches);
  tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t i) { modeller.choose_model(candidates[i]); });
  merge_greedily(candidates, neighbours_3d(frame, find_adjacencies(frame, patches.labels, params), params), modeller);

  SurfaceSet set;
  set.labels = cv::Mat_<int>(patches.labels.size(), 0);
  for (Candidate& candidate : candidates) {
    if (candidate.pixels.empty()) continue;
    std::sort(candidate.pixels.begin(), candidate.pixels.end());
    set.surfaces.push_back({std::move(candidate.pixels), std::move(candidate.model)});
    for (const int pixel : set.surfaces.back().pixels) set.labels.ptr<int>()[pixel] = int(set.surfaces.size());
  }
  set.adjacencies = find_adjacencies(frame, set.labels, params);
  return set;
}

}  // namespace gestalt
