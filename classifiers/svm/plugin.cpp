// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "svm.h"

GESTALT_PLUGIN(gestalt::component<gestalt::Svm>("svm", "1.0.0",
                                                "Support vector machine with RBF kernel and probabilities (libsvm)"))
