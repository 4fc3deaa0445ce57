// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <string_view>

namespace gestalt::python {

/// A text that may contain a path: bytes that are not UTF-8 become what Python has for them in paths.
inline pybind11::str text_of(std::string_view text) {
  PyObject* decoded = PyUnicode_DecodeUTF8(text.data(), pybind11::ssize_t(text.size()), "surrogateescape");
  if (!decoded) throw pybind11::error_already_set();
  return pybind11::reinterpret_steal<pybind11::str>(decoded);
}

}  // namespace gestalt::python
