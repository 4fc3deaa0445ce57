// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/segmentation.h"

namespace gestalt {

std::string_view name_of(Role role) { return role == Role::object ? "object" : "background"; }

cv::Mat_<std::uint16_t> object_labels(const Segmentation& segmentation) {
  cv::Mat_<std::uint16_t> objects = segmentation.labels.clone();
  for (std::uint16_t& label : objects)
    if (label > 0 && segmentation.segments[std::size_t(label) - 1].role == Role::background) label = 0;
  return objects;
}

}  // namespace gestalt
