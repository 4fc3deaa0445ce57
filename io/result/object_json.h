// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "gestalt/core/pipeline/segmenter.h"

namespace gestalt {

/// The objects of a frame as result.json has them (docs/objects.md): describe_objects(), with masks as run lengths.
nlohmann::json objects_json(const SegmentedFrame& found);

}  // namespace gestalt
