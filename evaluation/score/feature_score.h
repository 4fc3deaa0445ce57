// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "gestalt/core/plugin/classifier.h"

namespace gestalt {

/// How well each value alone tells positive from negative samples (paper, Eq. 12, the F-score of Chen and Lin): the
/// squared distances of both classes' means from the mean of all, over the sum of both classes' variances (n - 1; Eq.
/// 12 is misprinted there: each class has its own n). 0 where the value is constant, infinite where it is constant in
/// each class but not in all, not a number with less than two samples of a class.
GESTALT_EXPORT std::vector<double> feature_scores(const Samples& samples);

}  // namespace gestalt
