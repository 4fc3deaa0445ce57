// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Out-of-line destructors: one vtable and one typeinfo for each interface, in the core, so that exceptions and casts
// work across plugins.

#include <nlohmann/json.hpp>

#include "gestalt/classifier.h"
#include "gestalt/clusterer.h"
#include "gestalt/error.h"
#include "gestalt/fitter.h"
#include "gestalt/relation.h"
#include "gestalt/solver.h"

namespace gestalt {

Error::~Error() = default;
ConfigError::~ConfigError() = default;
PluginError::~PluginError() = default;
ModelError::~ModelError() = default;
InputError::~InputError() = default;
TimeError::~TimeError() = default;
OutputError::~OutputError() = default;

Clusterer::~Clusterer() = default;
Fitter::~Fitter() = default;
SurfaceModel::~SurfaceModel() = default;
Relation::~Relation() = default;
Observation::~Observation() = default;
Measure::~Measure() = default;
Classifier::~Classifier() = default;
Predictor::~Predictor() = default;
Solver::~Solver() = default;

float SurfaceModel::squared_distance(const Eigen::Vector3f& p) const { return (foot(p).point - p).squaredNorm(); }

std::optional<Eigen::Vector2d> SurfaceModel::parameters(const Eigen::Vector3f&) const { return std::nullopt; }

std::unique_ptr<Observation> Relation::observe(const Images&) const { return nullptr; }

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
