// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cuts.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "gestalt/core/base/for_all.h"

namespace gestalt {

namespace {

constexpr int steps = 60;

/// Remembers what it was asked, as every cut asks for the same pairs. Thread-safe.
class RememberingPredictor final : public Predictor {
 public:
  explicit RememberingPredictor(std::shared_ptr<const Predictor> predictor) : predictor_(std::move(predictor)) {}

  double probability(std::span<const double> values) const override {
    const std::string key(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    {
      const std::lock_guard lock(mutex_);
      if (const auto known = known_.find(key); known != known_.end()) return known->second;
    }
    const double p = predictor_->probability(values);
    const std::lock_guard lock(mutex_);
    known_.emplace(key, p);
    return p;
  }

  nlohmann::json state() const override { return predictor_->state(); }

 private:
  std::shared_ptr<const Predictor> predictor_;
  mutable std::mutex mutex_;
  mutable std::unordered_map<std::string, double> known_;
};

Model remembering(Model model) {
  model.predictor = std::make_shared<RememberingPredictor>(model.predictor);
  return model;
}

/// To four digits, so that it reads well.
double legible(double value) {
  if (value == 0) return 0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 3);
  return unit < 1 ? std::round(value / unit) / std::round(1 / unit) : std::round(value / unit) * unit;
}

}  // namespace

Cut cut_of(const Segmentation& segmentation, std::size_t patches) {
  Cut cut{std::vector<int>(patches, 0), {}};
  for (const Segment& segment : segmentation.segments) {
    cut.roles.push_back(segment.role);
    for (const int patch : segment.surfaces) cut.labels[std::size_t(patch)] = int(cut.roles.size());
  }
  return cut;
}

std::vector<double> sweep_values(const Parameter& parameter, double current) {
  std::vector<double> values;
  if (parameter.maximum - parameter.minimum <= 10) {
    for (int i = 0; i <= steps; ++i)
      values.push_back(legible(parameter.minimum + (parameter.maximum - parameter.minimum) * i / steps));
  } else {
    const double centre = current == 0 ? 1 : current;
    for (int i = 0; i <= steps; ++i) values.push_back(legible(centre * std::exp2(10.0 * i / steps - 5)));
    for (const double end : {parameter.minimum, parameter.maximum})
      if (std::abs(end) <= 1e4) values.push_back(end);
  }
  for (double& value : values) value = std::clamp(value, parameter.minimum, parameter.maximum);
  values.push_back(current);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

Cuts sweep_solver(const Config& config, const Registry& registry, const Percept& percept, const Models& models) {
  const Models quick{remembering(models.structural),
                     models.assembly ? std::optional(remembering(*models.assembly)) : std::nullopt};
  const std::size_t patches = percept.surfaces().surfaces.size();
  const auto cut_with = [&](const Config& changed) {
    return cut_of(Pipeline(changed, registry).decide(percept, quick), patches);
  };
  Cuts result{{cut_with(config)}, {}};
  for (const Parameter& parameter : registry.parameters("solver", config.solver.plugin)) {
    if (parameter.type != Parameter::Type::real) continue;
    Sweep sweep{parameter, std::get<double>(config.solver.params.at(parameter.name)), {}, {}};
    sweep.values = sweep_values(parameter, sweep.current);
    std::vector<Cut> cuts(sweep.values.size());
    for_all(cuts.size(), [&](std::size_t i) {
      Config changed = config;
      changed.solver.params[parameter.name] = sweep.values[i];
      cuts[i] = cut_with(changed);
    });
    for (Cut& cut : cuts) {
      const auto known = std::find(result.cuts.begin(), result.cuts.end(), cut);
      sweep.cuts.push_back(int(known - result.cuts.begin()));
      if (known == result.cuts.end()) result.cuts.push_back(std::move(cut));
    }
    result.sweeps.push_back(std::move(sweep));
  }
  return result;
}

}  // namespace gestalt
