/* SPDX-FileCopyrightText: 2026 The Gestalt authors
 * SPDX-License-Identifier: BSD-3-Clause */
#pragma once

/** The plain-C handshake between the loader and a plugin. The loader reads it before it touches any C++ type of the
 *  plugin: magic, then interface_version, then fingerprint must match its own. This file never changes its layout;
 *  what changes is GESTALT_INTERFACE_VERSION. */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define GESTALT_MANIFEST_MAGIC 0x47455354u /* "GEST" */
#define GESTALT_INTERFACE_VERSION 6u       /* raised when an interface of the core changes */
#define GESTALT_ENTRY_SYMBOL "gestalt_plugin_manifest"

struct gestalt_component {
  const char* kind;             /* clusterer, fitter, relation, classifier, solver */
  const char* name;             /* the name in the config: [a-z][a-z0-9_]* */
  const char* version;          /* of the component, semantic versioning */
  const char* description;      /* one line */
  const void* (*factory)(void); /* gestalt::Factory<Kind>, alive for the life of the process */
};

struct gestalt_manifest {
  uint32_t magic;
  uint32_t interface_version;
  const char* fingerprint; /* gestalt::build_fingerprint() of the plugin's own build */
  uint32_t component_count;
  const struct gestalt_component* components;
};

typedef const struct gestalt_manifest* (*gestalt_entry)(void);

#ifdef __cplusplus
}
#endif
