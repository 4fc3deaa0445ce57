// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// A plugin that has the manifest that it is asked to have.

#include "gestalt/core/plugin/manifest.h"

extern "C" __attribute__((visibility("default"))) const gestalt_manifest* told_manifest = nullptr;

extern "C" __attribute__((visibility("default"))) const gestalt_manifest* gestalt_plugin_manifest() {
  return told_manifest;
}
