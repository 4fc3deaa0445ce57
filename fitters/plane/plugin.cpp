// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "plane.h"

GESTALT_PLUGIN(gestalt::component<gestalt::Plane>("plane", "1.0.0", "Plane by linear least squares (Section 4.2)"))
