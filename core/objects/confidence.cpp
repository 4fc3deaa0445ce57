// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "confidence.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "gestalt/core/base/disjoint_sets.h"

namespace gestalt {

namespace {

// Fitted to 1828 segments of 13 sets (docs/objects.md).
constexpr double constant = -6.824, of_join = 0.139, of_cut = -0.452, of_patches = 0.658, of_pixels = 0.844;
constexpr double least_p = 0.005;        // p is not more certain than that
constexpr double counting_share = 0.02;  // of the segment's pixels that a join holds at least, so that it counts
constexpr double doubtful_join = 0.6, doubtful_cut = 0.4;
constexpr std::size_t most_doubts = 3;

double log_odds(double p) {
  const double bound = std::clamp(p, least_p, 1 - least_p);
  return std::log(bound / (1 - bound));
}

/// Edges of an object to another one.
struct Contact {
  double weight = 0, sum = 0;  // of p
};

double smaller(const Graph& graph, const Edge& edge) {
  return std::min(graph.sizes[std::size_t(edge.a)], graph.sizes[std::size_t(edge.b)]);
}

void keep_first(std::vector<Doubt>& doubts, bool lowest) {
  std::stable_sort(doubts.begin(), doubts.end(), [&](const Doubt& x, const Doubt& y) {
    return lowest ? x.probability < y.probability : x.probability > y.probability;
  });
  if (doubts.size() > most_doubts) doubts.resize(most_doubts);
}

}  // namespace

std::vector<Certainty> find_certainties(const Segmentation& segmentation, double pixel_density) {
  const Graph& graph = segmentation.graph;
  std::vector<int> segment_of(graph.sizes.size(), -1);
  for (std::size_t s = 0; s < segmentation.segments.size(); ++s)
    for (const int surface : segmentation.segments[s].surfaces) segment_of[std::size_t(surface)] = int(s);
  const auto is_object = [&](int s) { return s >= 0 && segmentation.segments[std::size_t(s)].role == Role::object; };

  std::vector<std::vector<const Edge*>> inner(segmentation.segments.size());
  std::map<std::pair<int, int>, Contact> contacts;
  std::vector<Certainty> certainties(segmentation.segments.size());
  for (const Edge& edge : graph.edges) {
    const int a = segment_of[std::size_t(edge.a)], b = segment_of[std::size_t(edge.b)];
    if (!is_object(a) || !is_object(b)) continue;
    if (a == b) {
      inner[std::size_t(a)].push_back(&edge);
      continue;
    }
    const double weight = smaller(graph, edge);
    for (const auto& [own, other] : {std::pair(a, b), std::pair(b, a)}) {
      Contact& contact = contacts[{own, other}];
      contact.weight += weight;
      contact.sum += weight * edge.probability;
      if (edge.probability > doubtful_cut)
        certainties[std::size_t(own)].cuts.push_back({edge.a, edge.b, edge.probability});
    }
  }
  std::vector<double> likeliest_cut(segmentation.segments.size(), 0);
  for (const auto& [pair, contact] : contacts) {
    double& largest = likeliest_cut[std::size_t(pair.first)];
    if (contact.weight > 0) largest = std::max(largest, contact.sum / contact.weight);
  }

  DisjointSets sets(int(graph.sizes.size()));
  std::vector<double> held(graph.sizes.begin(), graph.sizes.end());  // pixels of each root's set
  for (std::size_t s = 0; s < segmentation.segments.size(); ++s) {
    if (!is_object(int(s))) continue;
    const Segment& segment = segmentation.segments[s];
    Certainty& certainty = certainties[s];
    std::stable_sort(inner[s].begin(), inner[s].end(),
                     [](const Edge* x, const Edge* y) { return x->probability > y->probability; });
    double weakest = 1;
    for (const Edge* edge : inner[s]) {
      const auto a = std::size_t(sets.find(edge->a)), b = std::size_t(sets.find(edge->b));
      if (a == b) continue;
      const double part = std::min(held[a], held[b]), both = held[a] + held[b];
      held[std::size_t(sets.join(edge->a, edge->b))] = both;
      if (part < counting_share * segment.pixel_count) continue;
      weakest = std::min(weakest, edge->probability);
      if (edge->probability < doubtful_join) certainty.joins.push_back({edge->a, edge->b, edge->probability});
    }
    keep_first(certainty.joins, true);
    keep_first(certainty.cuts, false);
    const double score = constant + of_join * log_odds(weakest) + of_cut * log_odds(likeliest_cut[s]) +
                         of_patches * std::log(double(segment.surfaces.size())) +
                         of_pixels * std::log(std::max(1.0, segment.pixel_count / pixel_density));
    certainty.confidence = 1 / (1 + std::exp(-score));
  }
  return certainties;
}

}  // namespace gestalt
