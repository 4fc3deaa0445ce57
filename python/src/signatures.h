// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

namespace gestalt::python {

/// Lets `inspect.signature`, help() and editors read the arguments of the module's functions and of its classes'
/// methods, which pybind11 writes into docstrings in a form of its own. Called once everything is bound.
void make_signatures_readable(const pybind11::module_& module);

}  // namespace gestalt::python
