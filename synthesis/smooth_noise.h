// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "random.h"

namespace gestalt::synthesis {

/// Normal noise with mean 0 and variance 1 that varies smoothly over about `radius` pixels.
cv::Mat_<float> smooth_noise(cv::Size size, double radius, Random& random);

/// The same for large radii: drawn on a coarse grid. Variance a little below 1.
cv::Mat_<float> broad_noise(cv::Size size, double radius, Random& random);

/// Normal noise exceeds the result with this probability (a logistic approximation, within 0.02).
float exceeded_with(double probability);

}  // namespace gestalt::synthesis
