// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "signatures.h"

#include <cstdlib>
#include <cstring>
#include <string>

namespace py = pybind11;

namespace gestalt::python {

namespace {

/// "(a: list[int], b: int = 1)" without the types, which signatures of builtins have not: "(a, b=1)".
std::string without_types(const std::string& arguments) {
  std::string names;
  int depth = 0;
  bool in_type = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const char c = arguments[i];
    if (c == '[' || c == '(') ++depth;
    if (c == ']' || c == ')') --depth;
    const bool outside = depth == 1 || (depth == 0 && c == ')');
    if (outside && arguments.compare(i, 3, " = ") == 0) {
      names += '=';
      in_type = false;
      i += 2;
      continue;
    }
    if (outside && (c == ',' || c == ')')) in_type = false;
    if (outside && c == ':') in_type = true;
    if (!in_type) names += c;
  }
  return names;
}

/// "name(arguments) -> type\n\ntext" as builtins have it: "name(names)\n--\n\ntext".
std::string as_builtin(const std::string& doc) {
  const std::size_t line = doc.find('\n'), arrow = doc.rfind(" -> ", line), open = doc.find('(');
  if (line == std::string::npos || arrow == std::string::npos || open > arrow) return doc;
  const std::size_t text = doc.find_first_not_of('\n', line);
  return doc.substr(0, open) + without_types(doc.substr(open, arrow - open)) + "\n--\n\n" +
         (text == std::string::npos ? "" : doc.substr(text));
}

void make_readable(py::handle function) {
  PyObject* const own =
      PyInstanceMethod_Check(function.ptr()) ? PyInstanceMethod_GET_FUNCTION(function.ptr()) : function.ptr();
  if (!PyCFunction_Check(own)) return;
  PyMethodDef& definition = *reinterpret_cast<PyCFunctionObject*>(own)->m_ml;
  if (!definition.ml_doc) return;
  char* const doc = ::strdup(as_builtin(definition.ml_doc).c_str());
  if (!doc) return;
  std::free(const_cast<char*>(definition.ml_doc));  // pybind11 allocates it with strdup() and frees the one it finds
  definition.ml_doc = doc;
}

}  // namespace

void make_signatures_readable(const py::module_& module) {
  for (const auto& [name, member] : py::reinterpret_borrow<py::dict>(module.attr("__dict__"))) {
    if (!PyType_Check(member.ptr())) {
      make_readable(member);
      continue;
    }
    const py::dict members(member.attr("__dict__"));
    for (const auto& [method, function] : members) make_readable(function);
  }
}

}  // namespace gestalt::python
