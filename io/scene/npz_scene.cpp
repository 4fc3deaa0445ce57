// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "npz_scene.h"

#include <array>
#include <cmath>
#include <iomanip>
#include <locale>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "colour_image.h"
#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/depth_reading.h"
#include "gestalt/io/scene/ground_truth.h"
#include "image_frame.h"
#include "most_pixels.h"
#include "npz_file.h"
#include "scene_camera.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

using Arrays = std::map<std::string, NpyArray>;
using Shape = std::vector<std::size_t>;

// What people call them; the first is ours.
const std::vector<std::string> colour_names{"rgb", "color", "colour", "image"};
const std::vector<std::string> camera_names{"K", "cam_K", "intrinsics", "intrinsic", "camera_matrix"};
const std::vector<std::string> other_names{"depth", "label", "depth_scale"};

std::vector<std::string> all_names() {
  std::vector<std::string> names = other_names;
  names.insert(names.end(), colour_names.begin(), colour_names.end());
  names.insert(names.end(), camera_names.begin(), camera_names.end());
  return names;
}

std::string shape_text(const Shape& shape) {
  std::string all;
  for (const std::size_t extent : shape) all += (all.empty() ? "" : ", ") + std::to_string(extent);
  return "(" + all + ")";
}

/// Without extents of 1 at the begin, as of a batch of one, and at the end behind the first `kept`.
Shape squeezed(Shape shape, std::size_t kept) {
  while (shape.size() > kept && shape.front() == 1) shape.erase(shape.begin());
  while (shape.size() > kept && shape.back() == 1) shape.pop_back();
  return shape;
}

/// The arrays of one file.
class NpzScene {
 public:
  explicit NpzScene(const fs::path& file) : file_(file), arrays_(read_npz(file, all_names())) {
    const NpyArray* depth = find("depth");
    if (!depth)
      throw InputError(file.string() + ": has no array 'depth'; write numpy.savez_compressed(file, depth=, rgb=, K=)");
    const Shape shape = squeezed(depth->shape, 2);
    if (shape.size() != 2 || depth->count() == 0 || depth->count() > std::size_t{most_pixels})
      fail("depth", "has the shape " + shape_text(depth->shape) + "; it must be (height, width), up to 2^26 pixels");
    size_ = cv::Size(int(shape[1]), int(shape[0]));
    colour_ = read_colour();
  }

  DepthReading depth(const ReadOptions& options, const std::optional<CameraFile>& camera) const {
    const NpyArray& array = arrays_.at("depth");
    if (array.kind == 'b') fail("depth", "is boolean; it must have integers or floats");
    const bool whole = array.kind != 'f';
    DepthReading depth{cv::Mat_<float>(size_), whole ? whole_unit(options, camera) : unit_of_floats(options), whole,
                       options.depth_kind};
    const bool rotated = whole && depth.kind == DepthKind::rotated;
    for (std::size_t i = 0; i < array.count(); ++i) {
      double value = array.at(i);
      if (rotated) value = rotated_right(value);
      depth.metres.ptr<float>()[i] = float(value * depth.unit.metres);
    }
    return depth;
  }

  /// Of the size of depth.
  cv::Mat colour() {
    if (colour_.empty() || colour_.size() == size_) return colour_;
    if (!same_aspect(colour_.size(), size_))
      fail(colour_name_, "is of " + text(colour_.size()) + " pixels, depth of " + text(size_) +
                             "; register one to the other and write arrays of the same size");
    notes_.push_back(file_.string() + ": array '" + colour_name_ + "' is of " + text(colour_.size()) +
                     " pixels, depth of " + text(size_) + ": taken for the same view and resampled");
    return resized(colour_, size_);
  }

  cv::Mat_<int> label() const {
    const NpyArray* array = find("label");
    if (!array) return {};
    if (array->kind == 'f') fail("label", "is of floats; write it as integers, as label.astype('uint16') has them");
    if (array->shape != Shape{rows(), columns()})
      fail("label",
           "must have the shape of depth, " + shape_text({rows(), columns()}) + ", it has " + shape_text(array->shape));
    cv::Mat_<int> label(size_);
    for (std::size_t i = 0; i < label.total(); ++i) {
      const double value = array->at(i);
      if (value < 0 || value > 65535) fail("label", "has a label outside 0 to 65535");
      label.ptr<int>()[i] = int(value);
    }
    return label;
  }

  /// K has no file and tells no depth_scale.
  CameraFile camera(const ReadOptions& options) {
    if (options.camera) return *options.camera;
    for (const std::string& name : camera_names)
      if (const NpyArray* array = find(name)) return camera_of(name, *array);
    const auto found = find_camera_file(file_);
    if (!found)
      throw InputError(file_.string() +
                       ": has no array 'K', nor is there a camera.yaml; write K (3, 3), or give --camera FILE, or "
                       "--fx, --fy, --cx and --cy");
    return read_camera(*found);
  }

  /// What was taken for likely.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  [[noreturn]] void fail(const std::string& array, const std::string& what) const {
    throw InputError(file_.string() + ": array '" + array + "' " + what);
  }

  const NpyArray* find(const std::string& name) const {
    const auto found = arrays_.find(name);
    return found == arrays_.end() ? nullptr : &found->second;
  }

  /// A camera that is given goes before the array.
  DepthUnit whole_unit(const ReadOptions& options, const std::optional<CameraFile>& camera) const {
    const NpyArray* array = find("depth_scale");
    if (!array || options.depth_scale || (options.camera && options.camera->depth_scale))
      return unit_of_whole_numbers(options, camera);
    const double scale = array->count() == 1 ? array->at(0) : 0;
    if (!(scale >= 1e-6 && scale <= 1)) fail("depth_scale", "must be one number from 1e-06 to 1, metres per unit");
    return {scale, "the array depth_scale", false};
  }

  double rotated_right(double value) const {
    if (!(value >= 0 && value <= 65535)) fail("depth", "has numbers outside 0 to 65535, whose bits cannot be rotated");
    const auto bits = std::uint16_t(value);
    return std::uint16_t(bits >> 3 | bits << 13);
  }

  /// CV_8UC3, blue green red, of the array's own size; empty where there is none.
  cv::Mat read_colour() {
    for (const std::string& name : colour_names) {
      const NpyArray* array = find(name);
      if (!array) continue;
      colour_name_ = name;
      const Shape shape = squeezed(array->shape, 2);
      const bool channels_last = shape.size() == 3 && (shape[2] == 3 || shape[2] == 4);
      const bool channels_first = shape.size() == 3 && !channels_last && (shape[0] == 3 || shape[0] == 4);
      if ((shape.size() != 2 && !channels_last && !channels_first) || array->kind == 'b' || array->count() == 0 ||
          array->count() > 4 * std::size_t{most_pixels})
        fail(name, "must be of numbers and have the shape " + shape_text({rows(), columns(), 3}) + ", it has " +
                       shape_text(array->shape));
      std::string problem;
      const cv::Mat rgb = as_colour(channels_first ? image_of_planes(*array, shape) : image_of(*array, shape), problem);
      if (!problem.empty()) fail(name, problem);
      cv::Mat bgr;
      cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
      return bgr;
    }
    return {};
  }

  /// The kind of pixels that as_colour() tells the range by.
  static int pixel_depth(const NpyArray& array) {
    return array.kind == 'f' ? CV_32F : array.size == 1 && array.kind == 'u' ? CV_8U : CV_32S;
  }

  static cv::Mat image_of(const NpyArray& array, const Shape& shape) {
    const int channels = shape.size() == 2 ? 1 : int(shape[2]);
    const cv::Size size{int(shape[1]), int(shape[0])};
    cv::Mat image(size, CV_MAKETYPE(pixel_depth(array), channels));
    copy(array, 0, image);
    return image;
  }

  /// (3, height, width), as networks take images.
  static cv::Mat image_of_planes(const NpyArray& array, const Shape& shape) {
    std::vector<cv::Mat> planes;
    for (std::size_t i = 0; i < shape[0]; ++i) {
      planes.emplace_back(int(shape[1]), int(shape[2]), pixel_depth(array));
      copy(array, i * shape[1] * shape[2], planes.back());
    }
    cv::Mat image;
    cv::merge(planes, image);
    return image;
  }

  /// The elements from the first on, as many as the image has.
  static void copy(const NpyArray& array, std::size_t first, cv::Mat& image) {
    const std::size_t count = image.total() * std::size_t(image.channels());
    for (std::size_t i = 0; i < count; ++i) {
      const double value = array.at(first + i);
      switch (image.depth()) {
        case CV_8U:
          image.ptr<std::uint8_t>()[i] = std::uint8_t(value);
          break;
        case CV_32F:
          image.ptr<float>()[i] = float(value);
          break;
        default:
          image.ptr<std::int32_t>()[i] = cv::saturate_cast<std::int32_t>(value);
      }
    }
  }

  Camera camera_of(const std::string& name, const NpyArray& array) {
    const Shape shape = squeezed(array.shape, 1);
    const bool matrix = shape.size() == 2 && (shape[0] == 3 || shape[0] == 4) && (shape[1] == 3 || shape[1] == 4);
    if (!matrix && shape != Shape{9}) fail(name, "must have the shape (3, 3), it has " + shape_text(array.shape));
    const std::size_t width = matrix ? shape[1] : 3;
    cv::Matx33d k;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        k(row, column) = array.at(std::size_t(row) * width + std::size_t(column));
    if (k(0, 2) == 0 && k(1, 2) == 0 && k(2, 0) > 0) k = k.t();  // column by column, as of Open3D
    if (k(1, 0) != 0 || k(2, 0) != 0 || k(2, 1) != 0 || k(2, 2) != 1 || k(0, 1) != 0)
      fail(name, "is not a matrix of intrinsics; it must be [[fx, 0, cx], [0, fy, cy], [0, 0, 1]], in pixels");
    Camera camera{size_.width, size_.height, k(0, 0), k(1, 1), k(0, 2), k(1, 2)};
    if (is_of_colour(camera)) return scaled_to_depth(name, camera);
    if (camera.cx > camera.width || camera.cy > camera.height) refuse_centre(name, camera);
    return camera;
  }

  /// Twice the principal point by the size of depth: near 1 where intrinsics are of its pixels.
  static cv::Vec2d doubled_centre(const Camera& k) { return {2 * k.cx / k.width, 2 * k.cy / k.height}; }

  /// Whether intrinsics are those of a colour image of the same view that has more pixels than depth.
  bool is_of_colour(const Camera& k) const {
    const double ratio = double(colour_.cols) / k.width;
    const cv::Vec2d centre = doubled_centre(k);
    return ratio > 1.4 && same_aspect(colour_.size(), size_) && std::abs(centre[0] / ratio - 1) < 0.2 &&
           std::abs(centre[1] / ratio - 1) < 0.2;
  }

  Camera scaled_to_depth(const std::string& name, const Camera& k) {
    notes_.push_back(file_.string() + ": array '" + name + "' is of the colour's " + text(colour_.size()) +
                     " pixels; scaled to depth's " + text(size_));
    const double ratio = double(colour_.cols) / k.width;
    const auto scaled = [&](double centre) { return (centre + 0.5) / ratio - 0.5; };  // (0, 0) is a pixel's centre
    return {k.width, k.height, k.fx / ratio, k.fy / ratio, scaled(k.cx), scaled(k.cy)};
  }

  [[noreturn]] void refuse_centre(const std::string& name, const Camera& k) const {
    const cv::Vec2d centre = doubled_centre(k);
    std::ostringstream factor;
    factor.imbue(std::locale::classic());
    factor << std::setprecision(3) << (centre[0] + centre[1]) / 2;
    fail(name, "has its principal point outside the depth image of " + text(size_) + ", as of an image with about " +
                   factor.str() + " times its columns; write K / [[" + factor.str() + "], [" + factor.str() +
                   "], [1]] with the exact ratio of the two, if both show the same view");
  }

  std::size_t rows() const { return std::size_t(size_.height); }
  std::size_t columns() const { return std::size_t(size_.width); }

  const fs::path& file_;
  Arrays arrays_;
  cv::Size size_;
  cv::Mat colour_;
  std::string colour_name_;
  std::vector<std::string> notes_;
};

template <class T>
NpyArray array_of(char kind, Shape shape, const T* values, std::size_t count) {
  return {kind, sizeof(T), std::move(shape), std::string(reinterpret_cast<const char*>(values), count * sizeof(T))};
}

}  // namespace

Input read_npz_scene(const fs::path& file, const ReadOptions& options) {
  NpzScene scene(file);
  Input input;
  const CameraFile camera = scene.camera(options);
  DepthReading depth = scene.depth(options, camera);
  const cv::Mat colour = scene.colour();
  input.warnings = scene.notes();
  try {
    set_ground_truth(input, scene.label(), depth.metres > 0, options.labels, file.string() + ": array 'label'");
  } catch (const InputError& error) {
    input.ground_truth_problem = error.what();
    input.warnings.push_back(input.ground_truth_problem + ". The scene is treated as having no ground truth");
  }
  set_frame_of_images(input, file.string(), colour, std::move(depth), camera, file);
  return input;
}

std::string encode_npz_scene(const ConvertedScene& scene) {
  const SceneImages& images = scene.images;
  const std::size_t rows = std::size_t(images.depth.rows), columns = std::size_t(images.depth.cols);
  const Camera& c = scene.camera;
  const std::array<double, 9> k{c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1};
  const cv::Mat_<std::uint16_t> depth = images.depth.clone();  // without gaps between rows
  std::map<std::string, NpyArray> arrays{
      {"depth", array_of('u', {rows, columns}, depth.ptr<std::uint16_t>(), depth.total())},
      {"depth_scale", array_of('f', {}, &scene.depth_scale, 1)},
      {"K", array_of('f', {3, 3}, k.data(), k.size())}};
  if (!images.label.empty()) {
    const cv::Mat_<std::uint16_t> label = images.label.clone();
    arrays["label"] = array_of('u', {rows, columns}, label.ptr<std::uint16_t>(), label.total());
  }
  if (!images.colour.empty()) {
    cv::Mat_<cv::Vec3b> rgb(images.colour.size());
    std::transform(images.colour.begin<cv::Vec3b>(), images.colour.end<cv::Vec3b>(), rgb.begin(),
                   [](const cv::Vec3b& bgr) { return cv::Vec3b(bgr[2], bgr[1], bgr[0]); });
    arrays["rgb"] = array_of('u', {rows, columns, 3}, rgb.ptr<std::uint8_t>(), 3 * rgb.total());
  }
  return encode_npz(arrays);
}

}  // namespace gestalt
