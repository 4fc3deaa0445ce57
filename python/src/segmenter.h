// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>
#include <vector>

#include "core_call.h"
#include "gestalt/core/pipeline/segmenter.h"
#include "gestalt/io/scene/input.h"

namespace gestalt::python {

namespace py = pybind11;

/// A config with its components, those in Python included. config: a file or None, for default.yaml; components:
/// dictionary of classes by name. Throws ConfigError, PluginError.
LoadedConfig load_config(const py::object& config, const std::vector<std::string>& overrides,
                         const py::dict& components);

/// The classes gestalt.Segmenter and gestalt.Result, and read_scene.
void bind_segmenter(py::module_& module);

/// The functions train, cross_validate and score.
void bind_learning(py::module_& module);

/// How scenes are to be read, in addition to what their files say; the arguments of the functions of Python.
struct Reading {
  std::optional<Camera> camera;
  std::optional<double> depth_scale;
  std::optional<std::string> depth_kind, labels;
};

/// Throws InputError for a scale that no unit has, and for an unknown kind or scheme.
ReadOptions read_options(const Reading& reading);

/// The config for scenes that are trained on together: the given one; or depth_only.yaml where that may replace the
/// default (depth_only_may_replace()) and no scene has colour, which is a warning.
py::object config_for_all(const py::object& config, const std::vector<std::string>& overrides,
                          const std::vector<std::filesystem::path>& scenes, const ReadOptions& options,
                          const Arena& arena);

/// Texts of one or many.
std::vector<std::filesystem::path> paths(const py::object& paths);

/// The same of what there must be. Throws InputError for none: nothing can be learnt from it, and its scores would be
/// perfect.
std::vector<std::filesystem::path> some_paths(const py::object& paths);

}  // namespace gestalt::python
