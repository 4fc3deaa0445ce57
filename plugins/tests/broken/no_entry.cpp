// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// A shared library, but no plugin.

#include "gestalt/core/base/export.h"

extern "C" GESTALT_EXPORT int nothing_of_gestalt();
extern "C" GESTALT_EXPORT int nothing_of_gestalt() { return 0; }
