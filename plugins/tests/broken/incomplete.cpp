// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// A component without a factory.

#include "gestalt/core/plugin/plugin.h"
#include "one_group.h"

extern "C" GESTALT_EXPORT const gestalt_manifest* gestalt_plugin_manifest();
extern "C" GESTALT_EXPORT const gestalt_manifest* gestalt_plugin_manifest() {
  static const gestalt_component components[] = {{"solver", "one_group", "1.0.0", "Every node in one group", nullptr}};
  static const gestalt_manifest manifest{GESTALT_MANIFEST_MAGIC, GESTALT_INTERFACE_VERSION, GESTALT_BUILD_FINGERPRINT,
                                         1, components};
  return &manifest;
}
