// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "gestalt/core/base/export.h"

namespace gestalt {

enum class ImageKind { png, jpeg, tiff, pnm, pfm, exr, npy, unknown };

/// By the first bytes of a file.
ImageKind image_kind(std::string_view bytes);

/// Of what is unknown, for messages: " (it is a WebP image)", or "".
std::string seen_as(std::string_view bytes);

/// The size that the header of a TIFF, PNM, PFM or EXR file declares, so that no memory is taken for what a few bytes
/// claim; nothing when the header is damaged.
GESTALT_EXPORT std::optional<cv::Size> declared_size(std::string_view bytes, ImageKind kind);

/// Whether an EXR file has one part, and one sample a pixel: others are not read.
GESTALT_EXPORT bool is_flat_exr(std::string_view bytes);

/// How many channels an EXR file declares; each takes memory for some hundred rows before any is read.
GESTALT_EXPORT std::size_t exr_channels(std::string_view bytes);

}  // namespace gestalt
