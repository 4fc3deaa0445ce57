// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "mean_normals.h"

GESTALT_PLUGIN(gestalt::component<gestalt::MeanNormals>("mean_normals", "1.0.0",
                                                        "r_nm, r_nv: difference of mean and variance of the normals"))
