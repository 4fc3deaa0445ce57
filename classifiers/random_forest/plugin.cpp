// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "random_forest.h"

GESTALT_PLUGIN(gestalt::component<gestalt::RandomForest>(
    "random_forest", "1.0.0", "Random forest; the probability is the mean of its trees (OpenCV)"))
