// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "gestalt/io/scene/input.h"

namespace gestalt {

/// What the numbers of labels can only be: osd or objects; nothing where they may be either. measured: not 0 where
/// there is depth; other pixels are not looked at.
std::optional<LabelScheme> guess_scheme(const cv::Mat_<int>& labels, const cv::Mat& measured);

/// Labels as object_of_label() reads them, of those that count objects: 1 for 0, and a multiple of ten from 20 for
/// every other number; 0 where nothing was measured. Throws InputError for more objects than 16 bits can tell.
cv::Mat_<std::uint16_t> labels_of_numbers(const cv::Mat_<int>& objects, const cv::Mat& measured);

}  // namespace gestalt
