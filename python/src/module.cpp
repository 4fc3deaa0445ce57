// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <malloc.h>
#include <pybind11/pybind11.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "arguments.h"
#include "components.h"
#include "core_call.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/plugin/registry.h"
#include "gestalt/core/plugin/running_component.h"
#include "segmenter.h"
#include "signatures.h"
#include "text.h"
#include "wording.h"

namespace gestalt::python {

namespace {

/// An error of the core as one of Python.
template <class E>
py::handle bind_error(py::module_& module, const char* name, py::handle base, const char* doc) {
  static const py::handle type = py::exception<E>(module, name, base).release();
  type.attr("__doc__") = doc;
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const E& error) {
      if (raise_interruption()) return;
      PyErr_SetObject(type.ptr(), text_of(in_python(error.what())).ptr());
    }
  });
  return type;
}

void bind_errors(py::module_& module) {
  const py::handle base = bind_error<Error>(module, "Error", PyExc_RuntimeError,
                                            "What any function of the package raises when it cannot do its work.");
  bind_error<ConfigError>(module, "ConfigError", base, "A config that does not hold.");
  bind_error<PluginError>(module, "PluginError", base, "A component that is missing or fails.");
  bind_error<ModelError>(module, "ModelError", base, "A model that is missing or does not fit.");
  bind_error<InputError>(module, "InputError", base, "A scene or image that cannot be used.");
  bind_error<TimeError>(module, "TimeError", base, "A frame that took longer than its time budget.");
  bind_error<OutputError>(module, "OutputError", base, "A file that cannot be written.");
}

/// A frame's images come and go; without this, and where the environment asks for it as Dask does, each one's memory
/// goes back to the system and is cleared again for the next, which takes as long as the frame itself.
void keep_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // bytes; the largest that is taken
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
}

/// A component that calls exit() would end the process as if all were done.
void refuse_exit() {
  const char* const component = own_component();
  if (!component) return;
  std::cerr << "gestalt: error: exit() was called while " << component
            << " was running; report this to its author, or remove it from the config" << std::endl;
  ::_exit(1);
}

}  // namespace

PYBIND11_MODULE(_gestalt, module) {
  module.doc() = "The compiled part of gestalt.";
  module.attr("__version__") = GESTALT_VERSION;
  std::atexit(refuse_exit);
  watch_process();
  bind_errors(module);
  bind_camera(module);
  bind_scene_view(module);
  bind_segmenter(module);
  bind_learning(module);
  module.def(
      "data_directory", [] { return data_directory().string(); }, "Where the installed configs and models are.");
  module.def("keep_freed_memory", keep_freed_memory,
             "Lets the process keep up to 256 MiB of freed memory for the next frame, whatever its environment says.");
  make_signatures_readable(module);
}

}  // namespace gestalt::python
