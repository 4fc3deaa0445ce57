// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "arguments.h"

#include <pybind11/numpy.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <tuple>

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/input.h"
#include "on_object.h"

namespace gestalt::python {

namespace py = pybind11;

namespace {

constexpr std::array<std::string_view, 6> camera_keys{"width", "height", "fx", "fy", "cx", "cy"};
constexpr const char* wanted_camera =
    "expected gestalt.Camera(width, height, fx, fy, cx, cy) or a dictionary with these keys";

std::string type_name(const py::handle& object) {
  return py::cast<std::string>(py::type::handle_of(object).attr("__name__"));
}

/// A string's bytes as Python writes them in paths. Throws what Python has for one that cannot be.
std::string bytes_of(const py::handle& text) {
  PyObject* const bytes = PyUnicode_EncodeFSDefault(text.ptr());
  if (!bytes) throw py::error_already_set();
  return std::string(py::reinterpret_steal<py::bytes>(bytes));
}

/// A value of a dictionary of overrides as it is written on the command line.
std::string value_text(const std::string& path, const py::handle& value) {
  if (py::isinstance<py::str>(value)) return bytes_of(value);
  if (value.is_none()) return "none";
  try {
    return py::cast<std::string>(py::module_::import("json").attr("dumps")(value, py::arg("allow_nan") = false));
  } catch (const py::error_already_set&) {
    throw py::type_error("overrides: the value of '" + path + "' is a " + type_name(value) +
                         "; expected a string, a number, True, False, or a list or dictionary of these");
  }
}

template <class Number>
Number camera_number(const py::handle& mapping, const char* key) {
  const py::object value = mapping[key];
  try {
    return py::cast<Number>(value);
  } catch (const py::cast_error&) {
    throw py::type_error("camera: '" + std::string(key) + "' is a " + type_name(value) + "; expected a number" +
                         (std::is_integral_v<Number> ? " of pixels without a fraction" : " of pixels"));
  }
}

Camera camera_of_dictionary(const py::dict& given) {
  for (const auto& [key, value] : given) {
    const std::string name = py::isinstance<py::str>(key) ? bytes_of(key) : type_name(key);
    if (std::find(camera_keys.begin(), camera_keys.end(), name) == camera_keys.end())
      throw InputError("camera: unknown key '" + name + "'; " + wanted_camera);
  }
  for (const std::string_view key : camera_keys)
    if (!given.contains(py::str(key.data(), key.size())))
      throw InputError("camera: the key '" + std::string(key) + "' is missing; " + wanted_camera);
  return {camera_number<int>(given, "width"), camera_number<int>(given, "height"), camera_number<double>(given, "fx"),
          camera_number<double>(given, "fy"), camera_number<double>(given, "cx"),  camera_number<double>(given, "cy")};
}

/// Of a matrix [fx 0 cx; 0 fy cy; 0 0 1].
Camera camera_of_matrix(const py::object& matrix, int width, int height) {
  const auto k = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(matrix);
  if (!k) throw py::error_already_set();
  if (k.ndim() != 2 || k.shape(0) != 3 || k.shape(1) != 3) throw InputError("K: expected an array of shape (3, 3)");
  const Camera camera{width, height, k.at(0, 0), k.at(1, 1), k.at(0, 2), k.at(1, 2)};
  if (k.at(0, 1) != 0 || k.at(1, 0) != 0 || k.at(2, 0) != 0 || k.at(2, 1) != 0 || k.at(2, 2) != 1)
    throw InputError("K: expected fx 0 cx, 0 fy cy, 0 0 1 by rows, in pixels; if it is by columns, pass K.T");
  return camera;
}

/// Throws InputError for a file without the image's size and for a lens that distorts.
Camera camera_of_file(const std::filesystem::path& file) {
  const CameraFile read = read_camera(file);
  if (read.camera.width == 0)
    throw InputError(file.string() + ": has no width and height; use gestalt.Camera(width, height, ...)");
  if (read.lens.distorts())
    throw InputError(file.string() +
                     ": has a lens that distorts; rectify the images, or read a scene folder that has this file");
  return read.camera;
}

auto as_tuple(const Camera& c) { return std::make_tuple(c.width, c.height, c.fx, c.fy, c.cx, c.cy); }

}  // namespace

std::vector<std::string> override_texts(const py::object& overrides) {
  std::vector<std::string> texts;
  if (overrides.is_none()) return texts;
  if (py::isinstance<py::dict>(overrides)) {
    for (const auto& [key, value] : py::reinterpret_borrow<py::dict>(overrides)) {
      if (!py::isinstance<py::str>(key))
        throw py::type_error("overrides: a key is a " + type_name(key) +
                             "; expected a path, as in "
                             "{\"structural.minimum_size\": 50}");
      const std::string path = bytes_of(key);
      texts.push_back(path + "=" + value_text(path, value));
    }
    return texts;
  }
  constexpr const char* wanted =
      "; expected a list of \"path=value\" or a dictionary, as in {\"structural.minimum_size\": 50}";
  if (py::isinstance<py::str>(overrides) || py::isinstance<py::bytes>(overrides) ||
      !py::isinstance<py::iterable>(overrides))
    throw py::type_error("overrides: got a " + type_name(overrides) + wanted);
  for (const py::handle text : overrides) {
    if (!py::isinstance<py::str>(text))
      throw py::type_error("overrides: got a " + type_name(text) + " in the list" + wanted);
    texts.push_back(bytes_of(text));
  }
  return texts;
}

Camera camera_of(const py::object& camera) {
  if (py::detail::make_caster<Self<Camera>> given; given.load(camera, false)) return Self<Camera>(given).object;
  if (py::isinstance<py::dict>(camera)) return camera_of_dictionary(py::reinterpret_borrow<py::dict>(camera));
  throw py::type_error((camera.is_none() ? std::string("camera: is missing") : "camera: got a " + type_name(camera)) +
                       "; " + wanted_camera);
}

std::optional<Camera> optional_camera(const py::object& camera) {
  if (camera.is_none()) return std::nullopt;
  return camera_of(camera);
}

py::array depth_array(const py::object& depth) {
  if (!py::isinstance<py::array>(depth))
    throw py::type_error((depth.is_none() ? std::string("depth: is missing") : "depth: got a " + type_name(depth)) +
                         "; expected a numpy array of shape (height, width): uint16 in millimetres or float in metres. "
                         "Without colour pass None for colour");
  return py::reinterpret_borrow<py::array>(depth);
}

void bind_camera(py::module_& module) {
  py::class_<Camera>(module, "Camera", "Pinhole intrinsics in pixels. Camera frame: x right, y down, z forward.")
      .def(py::init([](int width, int height, double fx, double fy, double cx, double cy) {
             return Camera{width, height, fx, fy, cx, cy};
           }),
           py::arg("width"), py::arg("height"), py::arg("fx"), py::arg("fy"), py::arg("cx"), py::arg("cy"))
      .def_static(
          "from_K", camera_of_matrix, py::arg("K"), py::arg("width"), py::arg("height"),
          "The camera of a matrix fx 0 cx, 0 fy cy, 0 0 1, (3, 3) by rows, in pixels; width and height are those "
          "of the image. Raises InputError for any other matrix.")
      .def_static("from_file", camera_of_file, py::arg("file"),
                  "The camera of a file of any kind that the command reads (docs/formats.md). Its unit of depth is not "
                  "kept. Raises InputError for one without the image's size, and for a lens that distorts.")
      .def(
          "__eq__",
          [](Self<Camera> self, const py::object& other) -> py::object {
            if (!py::isinstance<Camera>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
            return py::bool_(as_tuple(self.object) == as_tuple(camera_of(other)));
          },
          py::arg("other"))
      .def("__hash__", [](Self<Camera> self) { return py::hash(py::cast(as_tuple(self.object))); })
      .def_property_readonly("width", on_object(&Camera::width))
      .def_property_readonly("height", on_object(&Camera::height))
      .def_property_readonly("fx", on_object(&Camera::fx))
      .def_property_readonly("fy", on_object(&Camera::fy))
      .def_property_readonly("cx", on_object(&Camera::cx))
      .def_property_readonly("cy", on_object(&Camera::cy))
      .def(py::pickle(
          [](Self<Camera> self) {
            const Camera& c = self.object;
            return py::make_tuple(c.width, c.height, c.fx, c.fy, c.cx, c.cy);
          },
          [](const py::tuple& t) {
            return Camera{t[0].cast<int>(),    t[1].cast<int>(),    t[2].cast<double>(),
                          t[3].cast<double>(), t[4].cast<double>(), t[5].cast<double>()};
          }))
      .def("__repr__", [](Self<Camera> self) {
        const Camera& c = self.object;
        return py::str("gestalt.Camera(width={}, height={}, fx={}, fy={}, cx={}, cy={})")
            .format(c.width, c.height, c.fx, c.fy, c.cx, c.cy);
      });
}

}  // namespace gestalt::python
