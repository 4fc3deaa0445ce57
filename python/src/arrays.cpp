// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "arrays.h"

#include <array>
#include <opencv2/core.hpp>
#include <string>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/json_file.h"
#include "gestalt/io/scene/input.h"

namespace gestalt::python {

namespace {

std::string description(const py::array& array) {
  std::string text = "an array of " + py::cast<std::string>(py::str(array.dtype())) + " of shape (";
  for (py::ssize_t i = 0; i < array.ndim(); ++i) text += (i ? ", " : "") + std::to_string(array.shape(i));
  return text + ")";
}

/// The array with its rows one after the other.
template <class T>
py::array_t<T> packed(const py::array& array) {
  return py::array_t<T, py::array::c_style | py::array::forcecast>(array);
}

/// Red green blue as blue green red, or the other way round. On this thread alone, unlike cv::cvtColor().
cv::Mat swapped_channels(const cv::Mat& image) {
  cv::Mat swapped(image.size(), image.type());
  constexpr std::array from_to{0, 2, 1, 1, 2, 0};
  cv::mixChannels(&image, 1, &swapped, 1, from_to.data(), from_to.size() / 2);
  return swapped;
}

}  // namespace

cv::Mat colour_image(const py::object& colour) {
  if (colour.is_none()) return {};
  refuse_mask(colour, "colour");
  const auto array = py::array::ensure(colour);
  if (!array || array.ndim() != 3 || array.shape(2) != 3 || array.size() == 0 ||
      !py::isinstance<py::array_t<std::uint8_t>>(array))
    throw InputError("colour: expected None or uint8 of shape (height, width, 3), got " +
                     (array ? description(array) : std::string("no array")));
  const py::array_t<std::uint8_t> rows = packed<std::uint8_t>(array);
  const cv::Mat view(int(rows.shape(0)), int(rows.shape(1)), CV_8UC3, const_cast<std::uint8_t*>(rows.data()));
  return swapped_channels(view);
}

DepthReading depth_image(const py::array& depth, const ReadOptions& options) {
  refuse_mask(depth, "depth");
  const bool millimetres = depth.dtype().kind() == 'u' && depth.itemsize() == 2;  // of either order of bytes
  if (depth.ndim() != 2 || (!millimetres && depth.dtype().kind() != 'f'))
    throw InputError("depth: expected uint16 (millimetres) or float (metres) of shape (height, width), got " +
                     description(depth));
  const int height = int(depth.shape(0)), width = int(depth.shape(1));
  if (millimetres) {
    const py::array_t<std::uint16_t> rows = packed<std::uint16_t>(depth);
    return depth_reading(cv::Mat_<std::uint16_t>(height, width, const_cast<std::uint16_t*>(rows.data())), options,
                         options.camera);
  }
  const py::array_t<float> rows = packed<float>(depth);
  return float_reading(cv::Mat_<float>(height, width, const_cast<float*>(rows.data())), options);
}

py::array array_of(const cv::Mat& image) {
  const auto type = [&]() -> py::dtype {
    switch (image.depth()) {
      case CV_8U:
        return py::dtype::of<std::uint8_t>();
      case CV_16U:
        return py::dtype::of<std::uint16_t>();
      case CV_32S:
        return py::dtype::of<std::int32_t>();
      default:
        return py::dtype::of<float>();
    }
  }();
  const py::capsule owner(new cv::Mat(image), [](void* mat) { delete static_cast<cv::Mat*>(mat); });
  std::vector<py::ssize_t> shape{image.rows, image.cols};
  std::vector<py::ssize_t> strides{py::ssize_t(image.step[0]), py::ssize_t(image.elemSize())};
  if (image.channels() > 1) {
    shape.push_back(image.channels());
    strides.push_back(py::ssize_t(image.elemSize1()));
  }
  py::array array(type, shape, strides, image.data, owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::object colour_array(const cv::Mat& colour) {
  if (colour.empty()) return py::none();
  return array_of(swapped_channels(colour));
}

void refuse_mask(const py::handle& array, const std::string& name) {
  if (py::hasattr(array, "mask") && py::hasattr(array, "filled"))
    throw InputError(name + ": is a masked array; give " + name +
                     ".filled(VALUE), with 0 as the value for pixels without depth or label");
}

py::object object_of(const nlohmann::json& json) {
  const std::string text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return py::module_::import("json").attr("loads")(text);
}

nlohmann::json json_of(const py::object& object) {
  const py::object text = py::module_::import("json").attr("dumps")(object, py::arg("allow_nan") = false);
  return parse_json("state", py::cast<std::string>(text), deepest_json - 10);  // a model's file adds levels
}

}  // namespace gestalt::python
