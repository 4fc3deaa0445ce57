// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "pyramid_normals.h"

GESTALT_PLUGIN(gestalt::component<gestalt::PyramidNormals>(
    "pyramid_normals", "1.0.0", "Clusters of normals on three resolutions, selected from coarse to fine (Section 3)"))
