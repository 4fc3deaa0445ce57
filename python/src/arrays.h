// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

#include "gestalt/io/scene/depth_reading.h"

namespace gestalt::python {

namespace py = pybind11;

/// Colour of numpy, (height, width, 3) uint8 in the order red, green, blue, as the core has it. None: empty. Throws
/// InputError for any other array.
cv::Mat colour_image(const py::object& colour);

/// Depth of numpy, (height, width): uint16 in millimetres, or float in metres, unless the options tell the unit. Throws
/// InputError for any other array.
DepthReading depth_image(const py::array& depth, const ReadOptions& options = {});

/// A view of an image's data, which it keeps alive: (height, width) or (height, width, channels), read-only.
py::array array_of(const cv::Mat& image);

/// A copy in numpy's order of colours. None for an empty image.
py::object colour_array(const cv::Mat& colour);

/// Dictionaries, lists, numbers and texts.
py::object object_of(const nlohmann::json& json);

/// Throws what json.dumps() throws, also for numbers that are not finite.
nlohmann::json json_of(const py::object& object);

/// Throws InputError for an array of numpy.ma: what reads it as an array loses its mask.
void refuse_mask(const py::handle& array, const std::string& name);

}  // namespace gestalt::python
