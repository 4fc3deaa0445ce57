// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Built for an interface that this core does not have.

#include "gestalt/core/plugin/plugin.h"
#include "one_group.h"

extern "C" GESTALT_EXPORT const gestalt_manifest* gestalt_plugin_manifest();
extern "C" GESTALT_EXPORT const gestalt_manifest* gestalt_plugin_manifest() {
  // Nothing behind the field that differs may be read.
  static const gestalt_component* const trap = reinterpret_cast<const gestalt_component*>(16);
  static const gestalt_manifest manifest{GESTALT_MANIFEST_MAGIC, 0, nullptr, 1, trap};
  return &manifest;
}
