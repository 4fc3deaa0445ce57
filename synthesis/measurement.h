// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

namespace gestalt::synthesis {

/// What a depth sensor gives.
struct Measurement {
  cv::Mat_<std::uint16_t> depth;  ///< millimetres, 0 = no measurement
  cv::Mat_<int> body;             ///< as IdealView::body, of the surface whose depth was taken; nothing where no depth
};

}  // namespace gestalt::synthesis
