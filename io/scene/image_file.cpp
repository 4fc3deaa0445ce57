// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/image_file.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>

#include "colour_image.h"
#include "declared_size.h"
#include "exif_orientation.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"
#include "gestalt/io/scene/png_file.h"
#include "gestalt/io/scene/scene_path.h"
#include "jpeg_codec.h"
#include "loaded_codecs.h"
#include "most_pixels.h"
#include "npz_file.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t largest_image = std::uintmax_t{1} << 30;  // bytes

[[noreturn]] void fail(const fs::path& file, const std::string& what) { throw InputError(file.string() + ": " + what); }

/// An image of one channel; arrays of more than 2^26 elements, and of another shape than (height, width), are refused.
cv::Mat depth_of(const fs::path& file, const NpyArray& array) {
  std::vector<std::size_t> shape = array.shape;
  while (shape.size() > 2 && shape.back() == 1) shape.pop_back();
  while (shape.size() > 2 && shape.front() == 1) shape.erase(shape.begin());
  if (shape.size() != 2 || array.count() == 0 || array.count() > std::size_t{most_pixels} || array.kind == 'b')
    fail(file, "must be an array of numbers of the shape (height, width), of up to 2^26 pixels, to be a depth image");
  const cv::Size size{int(shape[1]), int(shape[0])};
  cv::Mat_<float> depth(size);
  bool whole = array.kind != 'f';
  for (std::size_t i = 0; i < array.count(); ++i) {
    const double value = array.at(i);
    whole = whole && value >= 0 && value <= 65535;
    depth.ptr<float>()[i] = float(value);
  }
  if (array.kind != 'f' && !whole) fail(file, "has a depth outside 0 to 65535; whole numbers must fit in 16 bits");
  cv::Mat_<std::uint16_t> units;
  if (!whole) return depth;
  depth.convertTo(units, CV_16U);  // exact: floats have 24 bits
  return units;
}

enum class Content { colour, depth };

/// What is neither PNG nor JPEG, as OpenCV decodes it; of an EXR file its channel of depth, where that is asked for.
cv::Mat decode_other(const fs::path& file, std::string_view bytes, ImageKind kind, Content what) {
  if (kind == ImageKind::unknown)
    fail(file, "is not an image that can be read" + seen_as(bytes) +
                   "; save it as PNG (depth: 16-bit grey), JPEG (colour only), TIFF, PGM, PPM or EXR");
  if (kind == ImageKind::exr && bytes.size() > 8 && !is_flat_exr(bytes))
    fail(file, "is an EXR file of several parts or of deep pixels; write its depth, or its colour, as one flat part");
  const auto size = declared_size(bytes, kind);
  if (!size) fail(file, "is truncated or damaged in its header; copy or write it again");
  if (size->width < 1 || size->height < 1 || std::int64_t{size->width} * size->height > most_pixels)
    fail(file, "declares " + std::to_string(size->width) + "x" + std::to_string(size->height) +
                   " pixels; images of 1 to 2^26 pixels can be read");
  constexpr std::size_t most_channels = 256, widest = std::size_t{1} << 19;  // columns of all channels
  if (kind == ImageKind::exr)
    if (const std::size_t channels = exr_channels(bytes);
        channels > most_channels || channels * std::size_t(size->width) > widest)
      fail(file, "has " + std::to_string(channels) + " channels of " + std::to_string(size->width) +
                     " columns; write those of depth, or of colour, to a separate file");
  cv::Mat image;
  std::string problem;
  if (kind == ImageKind::exr && what == Content::depth) problem = decode_exr_depth(bytes, image);
  if (problem.empty() && image.empty()) problem = decode_with_opencv(bytes, image);
  if (!problem.empty()) fail(file, "cannot be decoded (" + problem + "); write it again, as PNG if the error persists");
  return image;
}

std::string pixels_of(const cv::Mat& image) {
  static const std::array<const char*, 8> kinds{"8-bit",  "8-bit signed", "16-bit", "16-bit signed",
                                                "32-bit", "float",        "double", "half"};
  return std::string(kinds[std::size_t(image.depth())]) + (image.channels() == 1 ? " grey" : " colour");
}

}  // namespace

bool has_image_extension(const fs::path& file) {
  static const std::array<std::string_view, 10> extensions{".png", ".jpg", ".jpeg", ".tif", ".tiff",
                                                           ".pgm", ".ppm", ".pfm",  ".exr", ".npy"};
  const std::string extension = lower_extension(file);
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

bool is_depth_image(const fs::path& file) {
  try {
    read_depth_image(file);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

cv::Mat read_colour_image(const fs::path& file, std::vector<std::string>& notes) {
  const std::string bytes = read_bytes(file, largest_image);
  const ImageKind kind = image_kind(bytes);
  if (const int orientation = stored_orientation(bytes); orientation != 1)
    notes.push_back(file.string() + ": is to be displayed rotated or mirrored (EXIF orientation " +
                    std::to_string(orientation) +
                    "); its pixels are used as stored, like those of depth. If the depth image is stored rotated, "
                    "rotate this one too: mogrify -auto-orient");
  if (kind == ImageKind::png) return read_colour_png(file);
  cv::Mat image;
  if (kind == ImageKind::jpeg) {
    if (const std::string problem = decode_jpeg(bytes, image); !problem.empty())
      fail(file, "is not a complete JPEG image (" + problem + "); copy or write it again");
    return image;
  }
  if (kind == ImageKind::npy)
    fail(file, "is a numpy array; give colour as an image file, or with depth and K in an .npz file");
  std::string problem;
  cv::Mat colour = as_colour(decode_other(file, bytes, kind, Content::colour), problem);
  if (!problem.empty()) fail(file, problem);
  return colour;
}

cv::Mat read_depth_image(const fs::path& file) {
  const std::string bytes = read_bytes(file, largest_image);
  const ImageKind kind = image_kind(bytes);
  if (kind == ImageKind::png) return read_depth_png(file);
  if (kind == ImageKind::npy) return depth_of(file, read_npy(file));
  if (kind == ImageKind::jpeg)
    fail(file, "is a JPEG image, whose compression alters depth values; save the sensor's depth as 16-bit PNG or TIFF");
  cv::Mat image = decode_other(file, bytes, kind, Content::depth);
  // Renderers that have no channel of depth write it into all of them, or into red.
  if (kind == ImageKind::exr && image.channels() > 1) cv::extractChannel(image, image, 2);
  if (image.type() == CV_64FC1) image.convertTo(image, CV_32F);
  if (image.type() == CV_16UC1 || image.type() == CV_32FC1) return image;
  fail(file,
       "is " + pixels_of(image) +
           ", depth must be 16-bit grey or float; save the sensor's depth as uint16 (millimetres, or another unit "
           "named by depth_scale in camera.yaml), not a picture of it");
}

}  // namespace gestalt
