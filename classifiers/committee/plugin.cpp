// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "committee.h"

GESTALT_PLUGIN(gestalt::component<gestalt::Committee>(
    "committee", "1.0.0", "Mean probability of a support vector machine and a random forest"))
