// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace gestalt::python {

/// A message that names options of the command, with what they are here.
std::string in_python(const std::string& message);

/// A warning of Python. Throws where Python makes it an exception.
void warn(const std::string& message);

/// Each one, those of the core in the words of Python, once.
void warn(const std::vector<std::string>& messages);

}  // namespace gestalt::python
