// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ros_message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "byte_reader.h"
#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/jpeg_codec.h"
#include "gestalt/io/scene/most_pixels.h"
#include "gestalt/io/scene/png_file.h"

namespace gestalt {

namespace {

/// Fields as ROS 1 or CDR (little-endian) has them.
class MessageReader {
 public:
  MessageReader(const BagTopic& topic, std::string_view message)
      : reader_(message), cdr_(topic.encoding == MessageEncoding::cdr) {
    if (!cdr_) return;
    const std::string_view start = reader_.bytes(encapsulation);
    if (start[0] != 0 || start[1] != 1) throw InputError("a message is not in plain little-endian CDR");
  }

  template <class Number>
  Number number() {
    if (cdr_) reader_.align(sizeof(Number), encapsulation);
    return reader_.number<Number>();
  }

  std::string_view text() {
    const auto size = number<std::uint32_t>();
    std::string_view text = reader_.bytes(size);
    if (cdr_ && text.ends_with('\0')) text.remove_suffix(1);
    return text;
  }

  std::string_view bytes() { return reader_.bytes(number<std::uint32_t>()); }

  /// The time of std_msgs/Header, nanoseconds.
  std::uint64_t header() {
    if (!cdr_) number<std::uint32_t>();  // sequence
    const std::uint64_t seconds = number<std::uint32_t>(), nanoseconds = number<std::uint32_t>();
    text();  // frame
    return seconds * 1'000'000'000 + nanoseconds;
  }

 private:
  static constexpr std::size_t encapsulation = 4;
  ByteReader reader_;
  bool cdr_;
};

bool is_compressed(const BagTopic& topic) { return topic.type == "sensor_msgs/CompressedImage"; }

/// The pixels of sensor_msgs/Image as they are, of a type that its encoding tells.
struct RawImage {
  std::string encoding;
  cv::Size size;
  bool big_endian;
  std::uint32_t step;
  std::string_view data;

  RawImage(const BagTopic& topic, std::string_view message) {
    MessageReader reader(topic, message);
    reader.header();
    const auto height = reader.number<std::uint32_t>(), width = reader.number<std::uint32_t>();
    if (height == 0 || width == 0 || std::uint64_t(height) * width > std::uint64_t(most_pixels))
      throw InputError("an image of " + std::to_string(width) + "x" + std::to_string(height) +
                       " pixels; there must be some, and at most 2^26");
    size = {int(width), int(height)};
    encoding = reader.text();
    big_endian = reader.number<std::uint8_t>() != 0;
    step = reader.number<std::uint32_t>();
    data = reader.bytes();
  }

  /// A copy as an image of that type.
  cv::Mat as(int type) const {
    const std::size_t row = std::size_t(size.width) * CV_ELEM_SIZE(type);
    if (step < row || data.size() < std::size_t(step) * std::size_t(size.height - 1) + row)
      throw InputError("an image of " + std::to_string(size.width) + "x" + std::to_string(size.height) + " pixels of " +
                       encoding + " has only " + std::to_string(data.size()) + " bytes in rows of " +
                       std::to_string(step));
    cv::Mat image(size, type);
    for (int v = 0; v < size.height; ++v)
      std::copy_n(data.data() + std::size_t(v) * step, row, reinterpret_cast<char*>(image.ptr(v)));
    if (big_endian && CV_ELEM_SIZE1(type) > 1) swap_bytes(image);
    return image;
  }

 private:
  static void swap_bytes(cv::Mat& image) {
    const std::size_t width = image.elemSize1(), count = image.total() * image.elemSize();
    for (std::size_t i = 0; i + width <= count; i += width) std::reverse(image.data + i, image.data + i + width);
  }
};

struct ColourEncoding {
  std::string_view name;
  int type;
  int conversion;  ///< of cv::cvtColor(); -1: none
};

constexpr std::array<ColourEncoding, 15> colour_encodings{{{"bgr8", CV_8UC3, -1},
                                                           {"8UC3", CV_8UC3, -1},
                                                           {"rgb8", CV_8UC3, cv::COLOR_RGB2BGR},
                                                           {"bgra8", CV_8UC4, cv::COLOR_BGRA2BGR},
                                                           {"rgba8", CV_8UC4, cv::COLOR_RGBA2BGR},
                                                           {"mono8", CV_8UC1, cv::COLOR_GRAY2BGR},
                                                           {"8UC1", CV_8UC1, cv::COLOR_GRAY2BGR},
                                                           {"yuv422", CV_8UC2, cv::COLOR_YUV2BGR_UYVY},
                                                           {"uyvy", CV_8UC2, cv::COLOR_YUV2BGR_UYVY},
                                                           {"yuv422_yuy2", CV_8UC2, cv::COLOR_YUV2BGR_YUY2},
                                                           {"yuyv", CV_8UC2, cv::COLOR_YUV2BGR_YUY2},
                                                           // OpenCV names the second row's second and third pixel.
                                                           {"bayer_rggb8", CV_8UC1, cv::COLOR_BayerBG2BGR},
                                                           {"bayer_bggr8", CV_8UC1, cv::COLOR_BayerRG2BGR},
                                                           {"bayer_gbrg8", CV_8UC1, cv::COLOR_BayerGR2BGR},
                                                           {"bayer_grbg8", CV_8UC1, cv::COLOR_BayerGB2BGR}}};

constexpr const char* compressed = "a compressed image";  // in messages

bool is_png(std::string_view data) { return data.starts_with("\x89PNG"); }

/// What compressed_depth_image_transport writes: a header of 12 bytes, then PNG of whole numbers; of floats, of a / z +
/// b.
cv::Mat decoded_depth(std::string_view format, std::string_view data) {
  ByteReader reader(data);
  reader.number<std::uint32_t>();
  const auto a = reader.number<float>(), b = reader.number<float>();
  const std::string_view stored = reader.bytes(reader.left());
  if (!is_png(stored)) throw InputError("compressed depth is not a PNG image");
  cv::Mat_<std::uint16_t> image = depth_of_png(compressed, stored);
  if (!format.starts_with("32FC1")) return image;
  cv::Mat_<float> metres(image.size());
  for (int v = 0; v < image.rows; ++v)
    for (int u = 0; u < image.cols; ++u) {
      const int number = image(v, u);
      metres(v, u) = number == 0 ? 0.0f : a / (float(number) - b);
    }
  return metres;
}

}  // namespace

bool has_images(const BagTopic& topic) { return topic.type == "sensor_msgs/Image" || is_compressed(topic); }

bool has_cameras(const BagTopic& topic) { return topic.type == "sensor_msgs/CameraInfo"; }

std::uint64_t stamp_of(const BagTopic& topic, std::string_view message) {
  return MessageReader(topic, message).header();
}

cv::Mat colour_of(const BagTopic& topic, std::string_view message) {
  if (is_compressed(topic)) {
    MessageReader reader(topic, message);
    reader.header();
    const std::string_view format = reader.text();
    const std::string_view data = reader.bytes();
    if (is_png(data)) return colour_of_png(compressed, data);
    cv::Mat image;
    if (const std::string problem = decode_jpeg(data, image); !problem.empty())
      throw InputError(std::string(compressed) + " of the format '" + std::string(format) + "': " + problem);
    return image;
  }
  const RawImage raw(topic, message);
  const auto known = std::ranges::find(colour_encodings, raw.encoding, &ColourEncoding::name);
  if (known == colour_encodings.end()) {
    std::string names;
    for (const ColourEncoding& encoding : colour_encodings)
      names.append(names.empty() ? "" : ", ").append(encoding.name);
    throw InputError("colour has the encoding '" + raw.encoding + "'; these can be read: " + names);
  }
  cv::Mat image = raw.as(known->type);
  const bool halves = known->type == CV_8UC2, bayer = known->name.starts_with("bayer");
  if ((halves && image.cols % 2 != 0) || (bayer && (image.cols < 2 || image.rows < 2)))
    throw InputError("an image of " + std::to_string(image.cols) + "x" + std::to_string(image.rows) +
                     " pixels cannot be of the encoding " + raw.encoding);
  if (known->conversion >= 0) cv::cvtColor(image, image, known->conversion);
  return image;
}

cv::Mat depth_of(const BagTopic& topic, std::string_view message) {
  if (is_compressed(topic)) {
    MessageReader reader(topic, message);
    reader.header();
    const std::string_view format = reader.text();
    if (format.find("compressedDepth") == format.npos)
      throw InputError("compressed depth has the format '" + std::string(format) +
                       "', which loses depth; record the topic of compressedDepth or of plain images");
    return decoded_depth(format, reader.bytes());
  }
  const RawImage raw(topic, message);
  if (raw.encoding == "16UC1" || raw.encoding == "mono16") return raw.as(CV_16UC1);
  if (raw.encoding == "32FC1") return raw.as(CV_32FC1);
  throw InputError("depth has the encoding '" + raw.encoding + "'; it must be 16UC1 or 32FC1");
}

CameraFile camera_of(const BagTopic& topic, std::string_view message, bool rectified) {
  MessageReader reader(topic, message);
  reader.header();
  const auto height = reader.number<std::uint32_t>(), width = reader.number<std::uint32_t>();
  const std::string_view model = reader.text();
  std::vector<double> coefficients;
  constexpr std::uint32_t most_coefficients = 14;
  const auto count = reader.number<std::uint32_t>();
  if (count > most_coefficients) throw InputError("camera_info has " + std::to_string(count) + " coefficients in D");
  for (std::uint32_t i = 0; i < count; ++i) coefficients.push_back(reader.number<double>());
  std::array<double, 9> k{}, r{};
  std::array<double, 12> p{};
  for (double& x : k) x = reader.number<double>();
  for (double& x : r) x = reader.number<double>();
  for (double& x : p) x = reader.number<double>();
  const auto binning_x = std::max(1u, reader.number<std::uint32_t>()),
             binning_y = std::max(1u, reader.number<std::uint32_t>());
  const auto left = reader.number<std::uint32_t>(), top = reader.number<std::uint32_t>();
  const auto part_height = reader.number<std::uint32_t>(), part_width = reader.number<std::uint32_t>();

  CameraFile file;
  const bool use_p = rectified && p[0] > 0 && p[5] > 0;
  Camera& camera = file.camera;
  camera.width = int(std::min((part_width ? part_width : width) / binning_x, 1u << 16));
  camera.height = int(std::min((part_height ? part_height : height) / binning_y, 1u << 16));
  camera.fx = (use_p ? p[0] : k[0]) / binning_x;
  camera.fy = (use_p ? p[5] : k[4]) / binning_y;
  camera.cx = ((use_p ? p[2] : k[2]) - left) / binning_x;
  camera.cy = ((use_p ? p[6] : k[5]) - top) / binning_y;
  const bool possible = camera.fx >= 0.01 && camera.fx <= 1e7 && camera.fy >= 0.01 && camera.fy <= 1e7 &&
                        camera.cx >= 0 && camera.cx <= std::max(camera.width, 1) && camera.cy >= 0 &&
                        camera.cy <= std::max(camera.height, 1);
  if (!possible)
    throw InputError(
        "camera_info has no intrinsics: focal lengths must be from 0.01 to 1e7 pixels, and the principal point in the "
        "image; give --camera");
  if (use_p || !std::ranges::all_of(coefficients, [](double x) { return std::isfinite(x); })) return file;
  const bool fisheye = model == "equidistant" || model == "fisheye";
  const std::array<std::string_view, 3> known{"plumb_bob", "rational_polynomial", ""};
  if (!fisheye && std::ranges::find(known, model) == known.end() &&
      std::ranges::any_of(coefficients, [](double x) { return x != 0; }))
    throw InputError("camera_info has the distortion model '" + std::string(model) +
                     "'; plumb_bob, rational_polynomial and equidistant can be read");
  file.lens = {fisheye ? Lens::Model::equidistant : Lens::Model::radial_tangential, std::move(coefficients)};
  return file;
}

}  // namespace gestalt
