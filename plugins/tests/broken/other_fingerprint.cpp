// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Built by another compiler for another Eigen.

#include "gestalt/core/plugin/plugin.h"
#include "one_group.h"

extern "C" GESTALT_EXPORT const gestalt_manifest* gestalt_plugin_manifest();
extern "C" GESTALT_EXPORT const gestalt_manifest* gestalt_plugin_manifest() {
  // Nothing behind the field that differs may be read.
  static const gestalt_component* const trap = reinterpret_cast<const gestalt_component*>(16);
  static const gestalt_manifest manifest{GESTALT_MANIFEST_MAGIC, GESTALT_INTERFACE_VERSION, "abi=1 eigen=2.0.0", 1,
                                         trap};
  return &manifest;
}
