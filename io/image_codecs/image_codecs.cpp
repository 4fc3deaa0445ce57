// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>

/// Decodes a whole image file, its pixels as they are stored. Gives "", or what is wrong.
extern "C" __attribute__((visibility("default"))) const char* gestalt_decode_image(const char* bytes, std::size_t size,
                                                                                   cv::Mat* image) {
  // The caller reports errors, with the file's name.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  try {
    const cv::Mat buffer(1, int(size), CV_8UC1, const_cast<char*>(bytes));
    *image = cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
    return image->empty() ? "its data are damaged, or of a kind that OpenCV does not read" : "";
  } catch (const std::exception&) {
    return "its data are damaged";
  }
}
