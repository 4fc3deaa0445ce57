// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "hull_view.h"

GESTALT_PLUGIN(gestalt::component<gestalt::HullView>(
    "hull_view", "1.0.0", "r_hb, r_ho, r_hn, r_hh: what is seen through the common hull of two patches"))
