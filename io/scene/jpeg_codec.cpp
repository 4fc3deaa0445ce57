// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "jpeg_codec.h"

#include <jpeglib.h>
#include <array>
#include <csetjmp>
#include <cstdio>  // before jpeglib.h, which needs it

#include "most_pixels.h"

namespace gestalt {

namespace {

/// libjpeg is left by longjmp, which skips destructors: functions that call setjmp have none, what they work on is
/// here.
struct JpegJob {
  jpeg_error_mgr errors{};  // first: libjpeg hands its address back
  std::jmp_buf leave{};
  std::array<char, JMSG_LENGTH_MAX> problem{};
};

[[noreturn]] void fail(j_common_ptr jpeg) {
  JpegJob& job = *reinterpret_cast<JpegJob*>(jpeg->err);
  jpeg->err->format_message(jpeg, job.problem.data());
  std::longjmp(job.leave, 1);
}

/// Warnings, of level -1, are of damage, behind which libjpeg makes pixels up.
void tell(j_common_ptr jpeg, int level) {
  if (level < 0) fail(jpeg);
}

/// Stops before the pixels, whose image is made by the caller. False: the problem is set.
bool begin(jpeg_decompress_struct& jpeg, JpegJob& job, std::string_view bytes) {
  if (setjmp(job.leave) != 0) return false;
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&jpeg, TRUE);
  jpeg.out_color_space = JCS_EXT_BGR;
  return true;
}

bool decode(jpeg_decompress_struct& jpeg, JpegJob& job, cv::Mat& image) {
  if (setjmp(job.leave) != 0) return false;
  jpeg_start_decompress(&jpeg);
  while (jpeg.output_scanline < jpeg.output_height) {
    JSAMPROW row = image.ptr(int(jpeg.output_scanline));
    jpeg_read_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_decompress(&jpeg);
  return true;
}

/// Closes what is open at the end of a scope.
struct ClosingJpeg {
  jpeg_decompress_struct& jpeg;
  ~ClosingJpeg() { jpeg_destroy_decompress(&jpeg); }
};

}  // namespace

std::string decode_jpeg(std::string_view bytes, cv::Mat& image) {
  JpegJob job;
  jpeg_decompress_struct jpeg{};
  jpeg.err = jpeg_std_error(&job.errors);
  job.errors.error_exit = fail;
  job.errors.emit_message = tell;
  const ClosingJpeg closing{jpeg};
  if (!begin(jpeg, job, bytes)) return job.problem.data();
  if (std::int64_t{jpeg.image_width} * jpeg.image_height > most_pixels) return "it has more than 2^26 pixels";
  image.create(int(jpeg.image_height), int(jpeg.image_width), CV_8UC3);
  return decode(jpeg, job, image) ? "" : job.problem.data();
}

}  // namespace gestalt
