// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/png_codec.h"

#include <png.h>

#include <csetjmp>
#include <cstring>
#include <vector>

#include "gestalt/core/base/error.h"

namespace gestalt {

namespace {

/// libpng leaves by longjmp, which skips destructors: functions that call setjmp have none, what they work on is here.
struct Job {
  std::string_view unread;
  std::string written;
  std::vector<png_bytep> rows;
  std::string problem;

  explicit Job(const cv::Mat& image) {
    for (int v = 0; v < image.rows; ++v) rows.push_back(const_cast<png_bytep>(image.ptr(v)));
  }
};

[[noreturn]] void fail(png_structp png, png_const_charp what) {
  static_cast<Job*>(png_get_error_ptr(png))->problem = what;
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

void read(png_structp png, png_bytep to, std::size_t size) {
  std::string_view& unread = static_cast<Job*>(png_get_io_ptr(png))->unread;
  if (unread.size() < size) png_error(png, "the file ends within an image");
  std::memcpy(to, unread.data(), size);
  unread.remove_prefix(size);
}

void write(png_structp png, png_bytep from, std::size_t size) {
  static_cast<Job*>(png_get_io_ptr(png))->written.append(reinterpret_cast<const char*>(from), size);
}

/// Closes what is open at the end of a scope.
struct Closing {
  png_structp png;
  png_infop info;
  decltype(&png_destroy_write_struct) destroy;
  ~Closing() { destroy(&png, &info); }
};

void destroy_read(png_structpp png, png_infopp info) { png_destroy_read_struct(png, info, nullptr); }

void decode(png_structp png, png_infop info, Job& job, bool colour, std::size_t row_bytes) {
  if (setjmp(png_jmpbuf(png)) != 0) return;
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // the file's header was checked before
  png_set_read_fn(png, &job, read);
  png_read_info(png, info);
  if (colour) {
    png_set_palette_to_rgb(png);
    png_set_expand_gray_1_2_4_to_8(png);
    png_set_gray_to_rgb(png);
    png_set_strip_alpha(png);
    png_set_bgr(png);
  }
  if (png_get_bit_depth(png, info) == 16) png_set_swap(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  if (png_get_rowbytes(png, info) != row_bytes || png_get_image_height(png, info) != job.rows.size())
    png_error(png, "the image differs in size or type from its header");
  png_read_image(png, job.rows.data());
  png_read_end(png, nullptr);
}

void encode(png_structp png, png_infop info, Job& job, const cv::Size& size, int bits, int colour_type) {
  if (setjmp(png_jmpbuf(png)) != 0) return;
  png_set_write_fn(png, &job, write, nullptr);
  png_set_IHDR(png, info, png_uint_32(size.width), png_uint_32(size.height), bits, colour_type, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  // Filtered and lightly compressed: a label image costs a tenth of the default's time for a few more bytes.
  png_set_compression_level(png, 1);
  png_write_info(png, info);
  png_set_bgr(png);
  png_set_swap(png);
  png_write_image(png, job.rows.data());
  png_write_end(png, info);
}

}  // namespace

std::string decode_png(std::string_view bytes, cv::Mat& image) {
  Job job(image);
  job.unread = bytes;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &job, fail, ignore_warning);
  if (!png) return "out of memory in the decoder";
  const Closing closing{png, png_create_info_struct(png), destroy_read};
  decode(png, closing.info, job, image.channels() == 3, image.cols * image.elemSize());
  return job.problem;
}

std::string encode_png(const cv::Mat& image) {
  const bool colour = image.type() == CV_8UC3;
  if (image.empty() || (!colour && image.type() != CV_8UC1 && image.type() != CV_16UC1))
    throw OutputError("the image cannot be encoded as PNG: it must have pixels of 8 or 16-bit grey or 8-bit colour");
  Job job(image);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &job, fail, ignore_warning);
  if (!png) throw OutputError("out of memory in the PNG encoder");
  const Closing closing{png, png_create_info_struct(png), png_destroy_write_struct};
  encode(png, closing.info, job, image.size(), int(8 * image.elemSize1()),
         colour ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY);
  if (!job.problem.empty()) throw OutputError("the image cannot be encoded as PNG: " + job.problem);
  return std::move(job.written);
}

}  // namespace gestalt
