// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "gestalt/core/pipeline/model.h"

namespace gestalt {

/// What each relation value of a pair contributes to its p(same): p, minus the mean of the p that the pair would have
/// were this one value anything of its range in training, all others as they are (the mean over five values spread
/// evenly over that range, its ends among them). It is in [-1, 1], positive where the value speaks for one object, and
/// asks nothing of the classifier but its p. Values act together, so that contributions need not add up to p. A value
/// that was constant in training contributes 0.
std::vector<double> contributions(const Model& model, std::span<const double> values);

}  // namespace gestalt
