// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <vector>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// Training pairs: relation values (raw; scaled where a Classifier gets them) and whether the two patches belong to one
/// object.
struct Samples {
  std::size_t columns = 0;
  std::vector<double> values;          ///< row-major, columns * positive.size()
  std::vector<std::uint8_t> positive;  ///< 1 same object, 0 not

  std::size_t rows() const { return positive.size(); }
  std::span<const double> row(std::size_t i) const { return {values.data() + i * columns, columns}; }

  /// Adds the rows of other samples, which have as many columns, or to which these, while empty, are made equal.
  void append(const Samples& more) {
    if (positive.empty()) columns = more.columns;
    values.insert(values.end(), more.values.begin(), more.values.end());
    positive.insert(positive.end(), more.positive.begin(), more.positive.end());
  }
};

/// Throws ModelError, telling the counts, unless there are positive and negative samples.
GESTALT_EXPORT void require_both_classes(const Samples& samples);

/// A trained classifier, immutable.
class GESTALT_EXPORT Predictor {
 public:
  virtual ~Predictor();

  /// p(same | r) in [0, 1] for one row of scaled values. Const and thread-safe.
  virtual double probability(std::span<const double> values) const = 0;

  /// p(same | r) of many rows, which are of equal length and follow each other in values: by default one row after the
  /// other. To override where many are cheaper at once, as for a classifier in another language.
  virtual void probabilities(std::span<const double> values, std::span<double> p) const;

  /// Everything that Classifier::restore needs; goes into the model file.
  virtual nlohmann::json state() const = 0;
};

/// Learns p(same | r) from labelled pairs (paper, Section 5).
class GESTALT_EXPORT Classifier {
 public:
  virtual ~Classifier();

  /// Deterministic for equal samples. Throws ModelError when the samples have only one class or no row.
  virtual std::unique_ptr<Predictor> train(const Samples& samples) const = 0;

  /// Rebuilds a predictor for rows of the given number of columns. The state may be untrusted: throws
  /// ModelError for anything that is not a complete, consistent state.
  virtual std::unique_ptr<Predictor> restore(const nlohmann::json& state, std::size_t columns) const = 0;
};

}  // namespace gestalt
