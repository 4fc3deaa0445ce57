// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include "gestalt/core/plugin/registry.h"

namespace gestalt::python {

/// Adds a class that is written in Python, derived from gestalt.Relation, Classifier or Solver, to the registry. What
/// it raises later, and arrays of another shape than asked for, are PluginErrors that name it.
void add_component(Registry& registry, const std::string& name, const pybind11::object& type);

/// The components to use: those given, or for None all that the program registered.
pybind11::dict registered(const pybind11::object& components);

/// Throws ValueError if a plugin that needs no config to be found has a component of that kind and name.
void require_new_name(const std::string& kind, const std::string& name);

/// The class gestalt.SceneView, what a relation sees of a frame.
void bind_scene_view(pybind11::module_& module);

}  // namespace gestalt::python
