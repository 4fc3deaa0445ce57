// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <string_view>

#include "gestalt/io/bag/bag.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

// Messages of sensor_msgs: Image, CompressedImage, CameraInfo. All throw InputError, without the file's name, for what
// is damaged, has an encoding that cannot be read, or more than most_pixels.

/// Whether a topic is of images, compressed or not.
bool has_images(const BagTopic& topic);

/// Whether it is of camera_info.
bool has_cameras(const BagTopic& topic);

/// Nanoseconds since 1970, of the header with which each of the messages begins.
std::uint64_t stamp_of(const BagTopic& topic, std::string_view message);

/// CV_8UC3, blue green red. Encodings: rgb8, bgr8, rgba8, bgra8, mono8, 8UC1, 8UC3, yuv422, yuv422_yuy2, bayer of 8
/// bits; JPEG and PNG in compressed ones.
cv::Mat colour_of(const BagTopic& topic, std::string_view message);

/// CV_16UC1 (16UC1, mono16: millimetres by convention) or CV_32FC1 (metres); compressedDepth is read, too.
cv::Mat depth_of(const BagTopic& topic, std::string_view message);

/// Of the image that the topic's messages belong to: binning and the region of interest are taken into account.
/// rectified: the images have no distortion, and P is their camera.
CameraFile camera_of(const BagTopic& topic, std::string_view message, bool rectified);

}  // namespace gestalt
