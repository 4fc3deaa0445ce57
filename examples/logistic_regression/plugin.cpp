// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gestalt/core/plugin/plugin.h>

#include "logistic_regression.h"

GESTALT_PLUGIN(gestalt::component<LogisticRegression>("logistic_regression", "1.0.0",
                                                      "Log odds as a weighted sum of the relation values"))
