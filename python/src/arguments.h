// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <optional>
#include <string>
#include <vector>

#include "gestalt/core/scene/frame.h"

namespace gestalt::python {

/// Overrides as "path=value", in order: a sequence of such strings, or a dictionary {path: value}, whose values are
/// strings, numbers, True, False, None, or lists and dictionaries as JSON has them. Throws TypeError for anything else.
std::vector<std::string> override_texts(const pybind11::object& overrides);

/// A gestalt.Camera, or one from a dictionary with width, height, fx, fy, cx and cy. Throws InputError for a missing or
/// unknown key, TypeError for anything else.
Camera camera_of(const pybind11::object& camera);

/// The same of an argument that may be None.
std::optional<Camera> optional_camera(const pybind11::object& camera);

/// The depth of a call as an array. Throws TypeError, which says what depth has to be, where it is left out or is not
/// an array.
pybind11::array depth_array(const pybind11::object& depth);

/// The class gestalt.Camera.
void bind_camera(pybind11::module_& module);

}  // namespace gestalt::python
