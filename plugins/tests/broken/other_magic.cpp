// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Has the entry symbol, but returns an invalid manifest.

#include "gestalt/core/plugin/plugin.h"
#include "one_group.h"

extern "C" GESTALT_EXPORT const gestalt_manifest* gestalt_plugin_manifest();
extern "C" GESTALT_EXPORT const gestalt_manifest* gestalt_plugin_manifest() {
  static const std::uint64_t something_else[8]{};
  return reinterpret_cast<const gestalt_manifest*>(something_else);
}
