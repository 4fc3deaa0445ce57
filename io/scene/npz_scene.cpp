// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "npz_scene.h"

#include <array>
#include <cmath>
#include <cstring>

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/depth_reading.h"
#include "gestalt/io/scene/ground_truth.h"
#include "image_frame.h"
#include "most_pixels.h"
#include "npz_file.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

using Arrays = std::map<std::string, NpyArray>;
using Shape = std::vector<std::size_t>;

const std::array<std::string, 5> names{"depth", "rgb", "label", "K", "depth_scale"};

std::string text(const Shape& shape) {
  std::string all;
  for (const std::size_t extent : shape) all += (all.empty() ? "" : ", ") + std::to_string(extent);
  return "(" + all + ")";
}

/// The arrays of one file.
class NpzScene {
 public:
  explicit NpzScene(const fs::path& file) : file_(file), arrays_(read_npz(file, names)) {
    const NpyArray* depth = find("depth");
    if (!depth)
      throw InputError(file.string() + ": has no array 'depth'; write numpy.savez_compressed(file, depth=, rgb=, K=)");
    if (depth->shape.size() != 2 || depth->count() == 0 || depth->count() > std::size_t{most_pixels})
      fail("depth", "has the shape " + text(depth->shape) + "; it must be (height, width), up to 2^26 pixels");
    size_ = cv::Size(int(depth->shape[1]), int(depth->shape[0]));
  }

  DepthReading depth(const ReadOptions& options, const std::optional<CameraFile>& camera) const {
    const NpyArray& array = arrays_.at("depth");
    if (array.kind == 'b') fail("depth", "is of booleans; it must be of integers or floats");
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

  cv::Mat colour() const {
    const NpyArray* array = find("rgb");
    if (!array) return {};
    if (array->kind != 'u' || array->size != 1 || array->shape != Shape{rows(), columns(), 3})
      fail("rgb",
           "must be of uint8 and have the shape " + text({rows(), columns(), 3}) + ", it has " + text(array->shape));
    cv::Mat_<cv::Vec3b> colour(size_);
    const auto* in = reinterpret_cast<const std::uint8_t*>(array->bytes.data());
    for (std::size_t i = 0; i < colour.total(); ++i)
      colour.ptr<cv::Vec3b>()[i] = {in[3 * i + 2], in[3 * i + 1], in[3 * i]};
    return colour;
  }

  cv::Mat_<int> label() const {
    const NpyArray* array = find("label");
    if (!array) return {};
    if (array->kind == 'f' || array->shape != Shape{rows(), columns()})
      fail("label",
           "must be of integers and have the shape " + text({rows(), columns()}) + ", it has " + text(array->shape));
    cv::Mat_<int> label(size_);
    for (std::size_t i = 0; i < label.total(); ++i) {
      const double value = array->at(i);
      if (value < 0 || value > 65535) fail("label", "has a label outside of 0 to 65535");
      label.ptr<int>()[i] = int(value);
    }
    return label;
  }

  /// K has no file and tells no depth_scale.
  CameraFile camera(const ReadOptions& options) const {
    if (options.camera) return *options.camera;
    const NpyArray* array = find("K");
    if (!array) {
      const auto found = find_camera_file(file_);
      if (!found)
        throw InputError(file_.string() + ": has no array 'K', nor is there a camera.yaml; write K, or give --camera");
      return read_camera(*found);
    }
    if (array->shape != Shape{3, 3}) fail("K", "must have the shape (3, 3), it has " + text(array->shape));
    return Camera{size_.width, size_.height, array->at(0), array->at(4), array->at(2), array->at(5)};
  }

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
    if (!(value >= 0 && value <= 65535))
      fail("depth", "has numbers outside of 0 to 65535, whose bits cannot be rotated");
    const auto bits = std::uint16_t(value);
    return std::uint16_t(bits >> 3 | bits << 13);
  }

  std::size_t rows() const { return std::size_t(size_.height); }
  std::size_t columns() const { return std::size_t(size_.width); }

  const fs::path& file_;
  Arrays arrays_;
  cv::Size size_;
};

template <class T>
NpyArray array_of(char kind, Shape shape, const T* values, std::size_t count) {
  return {kind, sizeof(T), std::move(shape), std::string(reinterpret_cast<const char*>(values), count * sizeof(T))};
}

}  // namespace

Input read_npz_scene(const fs::path& file, const ReadOptions& options) {
  const NpzScene scene(file);
  Input input;
  const CameraFile camera = scene.camera(options);
  DepthReading depth = scene.depth(options, camera);
  try {
    set_ground_truth(input, scene.label(), depth.metres > 0, options.labels, file.string() + ": array 'label'");
  } catch (const InputError& error) {
    input.ground_truth_problem = error.what();
    input.warnings.push_back(input.ground_truth_problem + ". It counts as without ground truth");
  }
  set_frame_of_images(input, file.string(), scene.colour(), std::move(depth), camera, file);
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
