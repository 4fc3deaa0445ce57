// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

namespace gestalt::synthesis {

/// Numbers the pixels as the OSD does: 0 without depth, 1-9 the disjoint parts of table and furniture, 20-29 those of
/// the first thing and so on, the largest part first, the tenth and later ones together; specks of fewer than 20 pixels
/// are counted to the largest part. Parts are 4-connected and not torn by more than 2 cm in depth. depth: millimetres,
/// 0 = none; body: as IdealView::body, read only where there is depth.
cv::Mat_<std::uint16_t> label_parts(const cv::Mat_<std::uint16_t>& depth, const cv::Mat_<int>& body);

}  // namespace gestalt::synthesis
