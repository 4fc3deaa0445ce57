// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "graph_cut.h"

#include <algorithm>
#include <tuple>

#include "gestalt/core/base/disjoint_sets.h"
#include "links.h"

namespace gestalt {

namespace {

std::vector<double> node_sizes(const Graph& graph, const std::string& counted) {
  if (counted == "patches") return std::vector<double>(graph.sizes.size(), 1.0);
  return {graph.sizes.begin(), graph.sizes.end()};
}

/// The growing components with the test that lets an edge join two of them. A component goes by its smallest node.
class Components {
 public:
  Components(std::vector<double> sizes, double k)
      : sets_(int(sizes.size())), sizes_(std::move(sizes)), internal_(sizes_.size(), 0.0), k_(k) {}

  int find(int node) { return sets_.find(node); }

  bool accept(int a, int b, double weight) const { return weight <= std::min(threshold(a), threshold(b)); }

  void join(int a, int b, double weight) {
    const double size = sizes_[std::size_t(a)] + sizes_[std::size_t(b)];
    const auto joined = std::size_t(sets_.join(a, b));
    sizes_[joined] = size;
    internal_[joined] = weight;  // weights come in ascending order, so it is the largest
  }

  std::vector<int> groups() { return sets_.groups(); }

 private:
  double threshold(int a) const { return internal_[std::size_t(a)] + k_ / sizes_[std::size_t(a)]; }

  DisjointSets sets_;
  std::vector<double> sizes_;
  std::vector<double> internal_;
  double k_;
};

std::vector<int> cut(const Graph& graph, Components components) {
  std::vector<Edge> edges = graph.edges;
  std::sort(edges.begin(), edges.end(), [](const Edge& x, const Edge& y) {
    return std::tuple(-x.probability, x.a, x.b) < std::tuple(-y.probability, y.a, y.b);
  });
  for (const Edge& edge : edges) {
    const int a = components.find(edge.a), b = components.find(edge.b);
    const double weight = 1 - edge.probability;
    if (a != b && components.accept(a, b, weight)) components.join(a, b, weight);
  }
  return components.groups();
}

/// What refuses an edge is a component whose threshold is below all weights that follow. It stays as it is for good, so
/// refused edges need no memory of it: they are refused again.
std::vector<int> cut_averaging(Links links, Components components) {
  for (Links::Candidate edge{}; links.take(edge);) {
    if (!components.accept(edge.a, edge.b, edge.weight)) continue;
    components.join(edge.a, edge.b, edge.weight);
    links.join(edge.a, edge.b);
  }
  return components.groups();
}

}  // namespace

const Parameters<GraphCut::Params>& GraphCut::parameters() {
  static const auto p =
      Parameters<Params>()
          .real("k", &Params::k, 0, 1e9, "", "tolerance over the internal difference, divided by the size")
          .choice("size", &Params::size, {"patches", "pixels"}, "what the size that divides k counts")
          .boolean("average_joined", &Params::average_joined,
                   "average the edges of two joined components to a third one")
          .choice("average_weight", &Params::average_weight, {"patches", "pixels"},
                  "size by which the average is weighted");
  return p;
}

std::vector<int> GraphCut::solve(const Graph& graph) const {
  Components components(node_sizes(graph, params_.size), params_.k);
  if (!params_.average_joined) return cut(graph, std::move(components));
  return cut_averaging({graph, node_sizes(graph, params_.average_weight)}, std::move(components));
}

}  // namespace gestalt
