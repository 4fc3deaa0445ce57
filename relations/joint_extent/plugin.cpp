// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "joint_extent.h"

GESTALT_PLUGIN(gestalt::component<gestalt::JointExtent>("joint_extent", "1.0.0",
                                                        "r_ex: extent of both patches together"))
