// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// The component that the calling thread works for, as "relation 'gabor'"; else the one that any thread began with
/// last; null before the first. For crash reports: may be called in a signal handler, and the text lives as
/// long as the process.
GESTALT_EXPORT const char* running_component() noexcept;

/// The component that the calling thread works for; null: none. For a report of the end of the process.
GESTALT_EXPORT const char* own_component() noexcept;

/// All that are running at the moment, each once, in no order. Takes a lock: not for signal handlers.
GESTALT_EXPORT std::vector<const char*> running_components();

}  // namespace gestalt
