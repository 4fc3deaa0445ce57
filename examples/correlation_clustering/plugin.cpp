// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gestalt/core/plugin/plugin.h>

#include "correlation_clustering.h"

GESTALT_PLUGIN(gestalt::component<CorrelationClustering>("correlation_clustering", "1.0.0",
                                                         "Groups with the largest sum of log odds within them"))
