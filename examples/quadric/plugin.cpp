// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gestalt/core/plugin/plugin.h>

#include "quadric.h"

GESTALT_PLUGIN(gestalt::component<Quadric>("quadric", "1.0.0", "Quadratic height over the plane through the points"))
