// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "multicut.h"

GESTALT_PLUGIN(gestalt::component<gestalt::Multicut>(
    "multicut", "1.0.0",
    "Correlation clustering of the log-odds of all edges: greedy contraction, Kernighan-Lin moves"))
