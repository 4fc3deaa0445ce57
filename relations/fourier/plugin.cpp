// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "fourier.h"

GESTALT_PLUGIN(gestalt::component<gestalt::Fourier>("fourier", "1.0.0",
                                                    "r_fo: Fourier filter match, similarity of the finest texture"))
