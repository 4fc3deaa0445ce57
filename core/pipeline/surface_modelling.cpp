// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/pipeline/surface_modelling.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>

#include "gestalt/core/base/error.h"

namespace gestalt {

namespace {

using SurfaceModels = std::vector<std::shared_ptr<const SurfaceModel>>;

/// A patch on its way to a surface.
struct Candidate {
  std::vector<int> pixels;
  std::vector<Eigen::Vector3f> points;  // parallel to pixels
  SurfaceModels models;                 // by fitter, null where there is none
  std::size_t fitter = 0;               // whose model is the best description
  double error = 0;                     // its S_err of Eq. 2, in points
  std::vector<int> cut_from;            // sorted: what its patches were cut from
};

/// Whether a clusterer cut a patch of the one from a patch of the other.
bool were_cut_apart(const Candidate& a, const Candidate& b) {
  auto i = a.cut_from.begin(), j = b.cut_from.begin();
  while (i != a.cut_from.end() && j != b.cut_from.end()) {
    if (*i == *j) return true;
    ++(*i < *j ? i : j);
  }
  return false;
}

/// A surface that explains two patches together, and what it saves over two (Eq. 8).
struct Merger {
  SurfaceModels models;  // those that were fitted
  std::size_t fitter = 0;
  double error = 0;
  double gain = 0;  // not positive: the patches stay two
};

class SurfaceModeller {
 public:
  SurfaceModeller(const Frame& frame, const std::vector<std::shared_ptr<const Fitter>>& fitters,
                  const SurfaceModellingParams& params)
      : noise_(frame.noise),
        deadline_(frame.deadline),
        largest_(params.largest_solid_angle * frame.camera.fx * frame.camera.fy),
        first_merger_(params.merger_fitters == "after_first" ? 1 : 0),
        fitters_(fitters),
        params_(params) {}

  /// Chooses the fitter with the largest savings.
  void choose_model(Candidate& patch) const {
    require_time();
    const double size = double(patch.points.size());
    double best = -std::numeric_limits<double>::infinity();
    patch.models.resize(fitters_.size());
    for (std::size_t f = 0; f < fitters_.size() && admits(f, patch.points.size()); ++f) {
      patch.models[f] = fitters_[f]->fit(patch.points);
      if (!patch.models[f]) continue;
      const double error = error_of(*patch.models[f], patch.points);
      const double savings = -cost(f) - params_.kappa_2 * error / size;
      if (savings <= best) continue;
      best = savings;
      patch.fitter = f;
      patch.error = error;
    }
    if (!patch.models[patch.fitter])
      throw PluginError("primitive level: no fitter could model a patch of " + std::to_string(patch.points.size()) +
                        " points; list a fitter that accepts any patch first in primitive.fitters");
  }

  /// The best single surface for two patches, if it is a better description than the two (Eq. 8). Normalised by the
  /// merged size, a plane through a table would swallow every small patch beside it: however badly it explains that
  /// patch, the share of its points in the whole is small. So either A_m is the size of the smaller patch, or the
  /// fitter of planes merges nothing and the large patches are left alone.
  Merger merge(const Candidate& a, const Candidate& b) const {
    require_time();
    if (were_cut_apart(a, b)) return {};
    const std::size_t size_a = a.points.size(), size_b = b.points.size();
    const double normalisation =
        params_.normalisation == "merged" ? double(size_a + size_b) : double(std::min(size_a, size_b));
    const double weight = params_.kappa_2 / normalisation;
    const double apart = cost(a.fitter) + cost(b.fitter) + weight * (a.error + b.error);
    Merger best;
    best.models.resize(fitters_.size());
    for (std::size_t f = first_merger_; f < fitters_.size() && admits(f, size_a) && admits(f, size_b); ++f) {
      // Errors only grow while they are summed up: a fit that cannot win any more is not looked at to the end.
      const double allowed = apart - cost(f) - best.gain;
      if (!(allowed > 0)) continue;
      best.models[f] = fit_merged(f, a, b);
      if (!best.models[f]) continue;
      double error = 0;
      for (const Candidate* patch : {&a, &b})
        if (weight * error < allowed) error += error_of(*best.models[f], patch->points, allowed / weight - error);
      const double gain = allowed + best.gain - weight * error;
      if (gain <= best.gain) continue;
      best.fitter = f;
      best.error = error;
      best.gain = gain;
    }
    return best;
  }

  /// Joins b into a, with the models that the merger has and those that it did not need.
  void absorb(Candidate& a, Candidate& b, Merger merger) const {
    for (std::size_t f = 0; f < fitters_.size() && admits(f, a.points.size() + b.points.size()); ++f)
      if (!merger.models[f]) merger.models[f] = fit_merged(f, a, b);
    std::vector<int> cut_from;
    std::set_union(a.cut_from.begin(), a.cut_from.end(), b.cut_from.begin(), b.cut_from.end(),
                   std::back_inserter(cut_from));
    a.cut_from = std::move(cut_from);
    a.pixels.insert(a.pixels.end(), b.pixels.begin(), b.pixels.end());
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    a.models = std::move(merger.models);
    a.fitter = merger.fitter;
    a.error = merger.error;
    b = {};
  }

  /// Why fitters have no model of a patch.
  std::vector<std::string> refusals(const Candidate& patch) const {
    std::vector<std::string> reasons;
    for (std::size_t f = 0; f < fitters_.size(); ++f)
      reasons.push_back(patch.models[f]                   ? ""
                        : !admits(f, patch.points.size()) ? "larger than largest_solid_angle"
                                                          : fitters_[f]->refusal(patch.points));
    return reasons;
  }

 private:
  void require_time() const { deadline_.require("the primitive level"); }

  double cost(std::size_t fitter) const { return params_.kappa_1 * fitters_[fitter]->parameter_count(); }

  bool admits(std::size_t fitter, std::size_t size) const { return fitter == 0 || double(size) <= largest_; }

  std::shared_ptr<const SurfaceModel> fit_merged(std::size_t f, const Candidate& a, const Candidate& b) const {
    if (a.models[f] && b.models[f]) return fitters_[f]->fit_merged(*a.models[f], a.points, *b.models[f], b.points);
    std::vector<Eigen::Vector3f> points = a.points;
    points.insert(points.end(), b.points.begin(), b.points.end());
    return fitters_[f]->fit(points);
  }

  /// S_err of Eq. 2, from an even sample of a large patch; or, once it is known to be larger than enough, any such
  /// number.
  double error_of(const SurfaceModel& model, const std::vector<Eigen::Vector3f>& points,
                  double enough = std::numeric_limits<double>::infinity()) const {
    const std::size_t step = (points.size() + error_samples - 1) / error_samples;
    const std::size_t samples = (points.size() + step - 1) / step;
    const double share = double(points.size()) / double(samples);
    double sum = 0;
    for (std::size_t i = 0; i < points.size() && sum <= enough; i += step) {
      const double sigma = params_.sigma * noise_.at(points[i].z());
      const double error = 1 - std::exp(-double(model.squared_distance(points[i])) / (sigma * sigma));
      sum += share * error;
    }
    return sum;
  }

  static constexpr std::size_t error_samples = 500;
  const DepthNoise noise_;
  const Deadline deadline_;
  const double largest_;            // pixels
  const std::size_t first_merger_;  // the first of the fitters whose surface may take the place of two
  const std::vector<std::shared_ptr<const Fitter>>& fitters_;
  const SurfaceModellingParams& params_;
};

/// Calls f with label, first pixel and end of every run of neighbouring pixels of one label, except 0.
template <class F>
void for_each_run(const cv::Mat_<int>& labels, const F& f) {
  const int* label = labels.ptr<int>();
  for (int pixel = 0, end = int(labels.total()); pixel < end;) {
    const int own = label[pixel], first = pixel;
    while (pixel < end && label[pixel] == own) ++pixel;
    if (own != 0) f(own, first, pixel);
  }
}

void append_run(std::vector<int>& pixels, int first, int end) {
  const std::size_t size = pixels.size();
  pixels.resize(size + std::size_t(end - first));
  std::iota(pixels.begin() + std::ptrdiff_t(size), pixels.end(), first);
}

std::vector<Candidate> gather(const Frame& frame, const PatchMap& patches) {
  std::vector<Candidate> candidates(std::size_t(patches.count));
  for (std::size_t i = 0; i < patches.cut_from.size(); ++i) candidates[i].cut_from = {patches.cut_from[i]};
  std::vector<std::size_t> sizes(candidates.size(), 0);
  for_each_run(patches.labels,
               [&](int label, int first, int end) { sizes[std::size_t(label) - 1] += std::size_t(end - first); });
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    candidates[i].pixels.reserve(sizes[i]);
    candidates[i].points.reserve(sizes[i]);
  }
  for_each_run(patches.labels, [&](int label, int first, int end) {
    Candidate& candidate = candidates[std::size_t(label) - 1];
    append_run(candidate.pixels, first, end);
    for (int pixel = first; pixel < end; ++pixel) candidate.points.push_back(frame.point(pixel));
  });
  return candidates;
}

using Pair = std::pair<int, int>;  // of candidates, the smaller number first

/// Pairs of patches with a touching pixel pair that is close in depth.
std::vector<Pair> neighbours_3d(const Frame& frame, const std::vector<Adjacency>& adjacencies,
                                const SurfaceModellingParams& params) {
  std::vector<Pair> neighbours;
  for (const Adjacency& adjacency : adjacencies)
    if (std::any_of(adjacency.border_2d.begin(), adjacency.border_2d.end(),
                    [&](const PixelPair& pair) { return are_close(frame, pair, params.neighbour_depth); }))
      neighbours.emplace_back(adjacency.a, adjacency.b);
  return neighbours;
}

/// Greedy surface merging (Algorithm 1), best gain first; ties go to the pair with the smaller numbers.
class GreedyMerging {
 public:
  GreedyMerging(std::vector<Candidate>& candidates, const SurfaceModeller& modeller)
      : candidates_(candidates), modeller_(modeller), neighbours_(candidates.size()), revision_(candidates.size(), 0) {}

  void run(const std::vector<Pair>& pairs) {
    for (const auto& [a, b] : pairs) {
      neighbours_[std::size_t(a)].insert(b);
      neighbours_[std::size_t(b)].insert(a);
    }
    consider(pairs);
    while (!queue_.empty()) {
      std::pop_heap(queue_.begin(), queue_.end());
      Entry best = std::move(queue_.back());
      queue_.pop_back();
      if (is_current(best)) join(best);
    }
  }

 private:
  /// A merger that pays, with the state of both patches that it was made for.
  struct Entry {
    Pair pair;
    Pair revisions;
    Merger merger;

    bool operator<(const Entry& other) const {  // the heap's top is the largest
      return std::pair(merger.gain, other.pair) < std::pair(other.merger.gain, pair);
    }
  };

  bool is_current(const Entry& entry) const { return entry.revisions == revisions(entry.pair); }
  Pair revisions(const Pair& pair) const {
    return {revision_[std::size_t(pair.first)], revision_[std::size_t(pair.second)]};
  }

  void consider(const std::vector<Pair>& pairs) {
    std::vector<Merger> mergers(pairs.size());
    tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
      mergers[i] = modeller_.merge(candidates_[std::size_t(pairs[i].first)], candidates_[std::size_t(pairs[i].second)]);
    });
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (!(mergers[i].gain > 0)) continue;
      queue_.push_back({pairs[i], revisions(pairs[i]), std::move(mergers[i])});
      std::push_heap(queue_.begin(), queue_.end());
    }
  }

  void join(Entry& entry) {
    const auto [kept, gone] = entry.pair;
    modeller_.absorb(candidates_[std::size_t(kept)], candidates_[std::size_t(gone)], std::move(entry.merger));
    ++revision_[std::size_t(kept)];
    ++revision_[std::size_t(gone)];
    std::set<int>& around = neighbours_[std::size_t(kept)];
    around.merge(neighbours_[std::size_t(gone)]);
    around.erase(kept);
    around.erase(gone);
    std::vector<Pair> pairs;
    for (const int other : around) {
      neighbours_[std::size_t(other)].erase(gone);
      neighbours_[std::size_t(other)].insert(kept);
      pairs.push_back(std::minmax(kept, other));
    }
    consider(pairs);
  }

  std::vector<Candidate>& candidates_;
  const SurfaceModeller& modeller_;
  std::vector<std::set<int>> neighbours_;
  std::vector<int> revision_;
  std::vector<Entry> queue_;  // a heap; entries of earlier revisions are passed over
};

}  // namespace

SurfaceSet model_surfaces(const Frame& frame, const PatchMap& patches,
                          const std::vector<std::shared_ptr<const Fitter>>& fitters,
                          const SurfaceModellingParams& params) {
  const SurfaceModeller modeller(frame, fitters, params);
  std::vector<Candidate> candidates = gather(frame, patches);
  std::vector<Pair> neighbours;
  tbb::parallel_invoke(
      [&] {
        tbb::parallel_for(std::size_t{0}, candidates.size(),
                          [&](std::size_t i) { modeller.choose_model(candidates[i]); });
      },
      [&] { neighbours = neighbours_3d(frame, find_adjacencies(frame, patches.labels, params), params); });
  GreedyMerging(candidates, modeller).run(neighbours);

  SurfaceSet set;
  set.labels = cv::Mat_<int>(patches.labels.size(), 0);
  for (Candidate& candidate : candidates) {
    if (candidate.pixels.empty()) continue;
    set.surfaces.push_back({{}, candidate.models[candidate.fitter], modeller.refusals(candidate)});
    set.surfaces.back().pixels.reserve(candidate.pixels.size());
    for (const int pixel : candidate.pixels) set.labels.ptr<int>()[pixel] = int(set.surfaces.size());
  }
  for_each_run(set.labels, [&](int label, int first, int end) {
    append_run(set.surfaces[std::size_t(label) - 1].pixels, first, end);
  });
  set.adjacencies = find_adjacencies(frame, set.labels, params);
  return set;
}

}  // namespace gestalt
