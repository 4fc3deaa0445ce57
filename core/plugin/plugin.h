// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Included by the plugin file of a component, and by nothing else:
///
///     #include "gestalt/core/plugin/plugin.h"
///     #include "my_relation.h"
///
///     GESTALT_PLUGIN(gestalt::component<MyRelation>("my_relation", "1.0.0", "What it measures, in one line"))
///
/// A component is a class derived from one of the five kinds with a default-constructible `struct Params`, a
/// `static const gestalt::Parameters<Params>& parameters()` and a constructor that takes a Params.

#include <iterator>
#include <memory>
#include <type_traits>

#include "gestalt/core/plugin/factory.h"
#include "gestalt/core/plugin/fingerprint.h"
#include "gestalt/core/plugin/manifest.h"

namespace gestalt {

template <class Component>
const void* factory_of() {
  using Kind = KindOf<Component>;
  static const Factory<Kind> factory{Component::parameters().declarations(),
                                     [](const ParameterValues& values) -> std::unique_ptr<Kind> {
                                       return std::make_unique<Component>(Component::parameters().read(values));
                                     }};
  return &factory;
}

template <class Component>
gestalt_component component(const char* name, const char* version, const char* description) {
  return {kind_name<KindOf<Component>>, name, version, description, &factory_of<Component>};
}

}  // namespace gestalt

#define GESTALT_PLUGIN(...)                                                                               \
  extern "C" GESTALT_EXPORT const gestalt_manifest* gestalt_plugin_manifest();                            \
  extern "C" GESTALT_EXPORT const gestalt_manifest* gestalt_plugin_manifest() {                           \
    static const gestalt_component components[] = {__VA_ARGS__};                                          \
    static const gestalt_manifest manifest{GESTALT_MANIFEST_MAGIC, GESTALT_INTERFACE_VERSION,             \
                                           GESTALT_BUILD_FINGERPRINT, std::size(components), components}; \
    return &manifest;                                                                                     \
  }
