// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <malloc.h>
#include <pybind11/pybind11.h>

#include "components.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/plugin/registry.h"
#include "gestalt/core/scene/frame.h"
#include "segmenter.h"

namespace gestalt::python {

namespace {

void bind_errors(py::module_& module) {
  const auto base = py::register_exception<Error>(module, "Error", PyExc_RuntimeError);
  base.doc() = "What any function of the package raises when it cannot do its work.";
  py::register_exception<ConfigError>(module, "ConfigError", base).doc() = "A config that does not hold.";
  py::register_exception<PluginError>(module, "PluginError", base).doc() = "A component that is missing or fails.";
  py::register_exception<ModelError>(module, "ModelError", base).doc() = "A model that is missing or does not fit.";
  py::register_exception<InputError>(module, "InputError", base).doc() = "A scene or image that cannot be used.";
  py::register_exception<TimeError>(module, "TimeError", base).doc() = "A frame that took longer than its time budget.";
  py::register_exception<OutputError>(module, "OutputError", base).doc() = "A file that cannot be written.";
}

void bind_camera(py::module_& module) {
  py::class_<Camera>(module, "Camera", "Pinhole intrinsics in pixels. Camera frame: x right, y down, z forward.")
      .def(py::init([](int width, int height, double fx, double fy, double cx, double cy) {
             return Camera{width, height, fx, fy, cx, cy};
           }),
           py::arg("width"), py::arg("height"), py::arg("fx"), py::arg("fy"), py::arg("cx"), py::arg("cy"))
      .def_readonly("width", &Camera::width)
      .def_readonly("height", &Camera::height)
      .def_readonly("fx", &Camera::fx)
      .def_readonly("fy", &Camera::fy)
      .def_readonly("cx", &Camera::cx)
      .def_readonly("cy", &Camera::cy)
      .def(py::pickle([](const Camera& c) { return py::make_tuple(c.width, c.height, c.fx, c.fy, c.cx, c.cy); },
                      [](const py::tuple& t) {
                        return Camera{t[0].cast<int>(),    t[1].cast<int>(),    t[2].cast<double>(),
                                      t[3].cast<double>(), t[4].cast<double>(), t[5].cast<double>()};
                      }))
      .def("__repr__", [](const Camera& c) {
        return py::str("gestalt.Camera(width={}, height={}, fx={}, fy={}, cx={}, cy={})")
            .format(c.width, c.height, c.fx, c.fy, c.cx, c.cy);
      });
}

/// A frame's images come and go; without this, and where the environment asks for it as Dask does, each one's memory
/// goes back to the system and is cleared again for the next, which takes as long as the frame itself.
void keep_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // bytes; the largest that is taken
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
}

}  // namespace

PYBIND11_MODULE(_gestalt, module) {
  module.doc() = "The compiled part of gestalt.";
  module.attr("__version__") = GESTALT_VERSION;
  bind_errors(module);
  bind_camera(module);
  bind_scene_view(module);
  bind_segmenter(module);
  bind_learning(module);
  module.def(
      "data_directory", [] { return data_directory().string(); }, "Where the installed configs and models are.");
  module.def("keep_freed_memory", keep_freed_memory,
             "Lets the process keep up to 256 MiB of freed memory for the next frame, whatever its environment says.");
}

}  // namespace gestalt::python
