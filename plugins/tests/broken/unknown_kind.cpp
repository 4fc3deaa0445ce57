// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Offers a kind of component that there is not.

#include "gestalt/core/plugin/plugin.h"
#include "one_group.h"

extern "C" GESTALT_EXPORT const gestalt_manifest* gestalt_plugin_manifest();
extern "C" GESTALT_EXPORT const gestalt_manifest* gestalt_plugin_manifest() {
  static const gestalt_component components[] = {
      {"relatoin", "one_group", "1.0.0", "Every node in one group", &gestalt::factory_of<gestalt::OneGroup>}};
  static const gestalt_manifest manifest{GESTALT_MANIFEST_MAGIC, GESTALT_INTERFACE_VERSION, GESTALT_BUILD_FINGERPRINT,
                                         1, components};
  return &manifest;
}
