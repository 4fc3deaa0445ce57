// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Out-of-line destructors: one vtable and one typeinfo for each interface, in the core, so that exceptions and casts
// work across plugins.

#include <nlohmann/json.hpp>

#include "gestalt/core/plugin/classifier.h"
#include "gestalt/core/plugin/clusterer.h"
#include "gestalt/core/plugin/fitter.h"
#include "gestalt/core/plugin/relation.h"
#include "gestalt/core/plugin/solver.h"

namespace gestalt {

Clusterer::~Clusterer() = default;
Fitter::~Fitter() = default;
Relation::~Relation() = default;
Measure::~Measure() = default;
Classifier::~Classifier() = default;
Predictor::~Predictor() = default;
Solver::~Solver() = default;

bool Solver::takes_all_pairs() const { return false; }

void Measure::measure(std::span<const SurfacePair> pairs, std::span<double> values) const {
  if (pairs.empty()) return;
  const std::size_t columns = values.size() / pairs.size();
  for (std::size_t i = 0; i < pairs.size(); ++i) (*this)(pairs[i], values.subspan(i * columns, columns));
}

void Predictor::probabilities(std::span<const double> values, std::span<double> p) const {
  if (p.empty()) return;
  const std::size_t columns = values.size() / p.size();
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = probability(values.subspan(i * columns, columns));
}

std::string Fitter::refusal(std::span<const Eigen::Vector3f>) const { return ""; }

std::shared_ptr<const SurfaceModel> Fitter::fit_merged(const SurfaceModel&, std::span<const Eigen::Vector3f> points_a,
                                                       const SurfaceModel&,
                                                       std::span<const Eigen::Vector3f> points_b) const {
  std::vector<Eigen::Vector3f> joined(points_a.begin(), points_a.end());
  joined.insert(joined.end(), points_b.begin(), points_b.end());
  return fit(joined);
}

}  // namespace gestalt
