// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "camera_formats.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gestalt/core/base/suggest.h"
#include "header_line.h"

namespace gestalt {

namespace {

using Keys = std::vector<std::string>;

constexpr int longest_side = 1 << 20;
// Beyond these focal lengths single precision has no useful points.
constexpr double shortest_focus = 0.01, longest_focus = 1e7;
constexpr double least_scale = 1e-6, largest_scale = 1;  // metres per unit

/// Where a format of named numbers has which. Keys that are empty are none of it.
struct Names {
  std::string width, height, fx, fy, cx, cy;
  std::string depth_scale{}, depth_factor{};  ///< metres per unit, units per metre
};

/// Reads a value that may be missing.
template <class Read>
auto if_there(const CameraEntries& entries, const std::string& key, const Read& read) -> decltype(read()) {
  return entries.has(key) ? read() : std::nullopt;
}

void take_size(CameraEntries& entries, const std::string& width, const std::string& height, CameraFile& result) {
  if (!entries.has(width) && !entries.has(height)) return;
  result.camera.width = entries.whole_number(width, 1, longest_side, "columns of the images").value_or(0);
  result.camera.height = entries.whole_number(height, 1, longest_side, "rows of the images").value_or(0);
}

/// A size in any of the words that files of matrices use for it.
void take_any_size(CameraEntries& entries, CameraFile& result) {
  static const std::array<std::array<const char*, 2>, 4> pairs{
      {{"image_width", "image_height"}, {"image_Width", "image_Height"}, {"width", "height"}, {"w", "h"}}};
  for (const auto& [width, height] : pairs)
    if (entries.has(width) || entries.has(height)) return take_size(entries, width, height, result);
  const std::string list = entries.first_of(
      {"resolution", "image_size", "imageSize", "img_size", "imageResolution", "cameraResolution", "size"});
  if (list.empty()) return;
  const auto numbers = entries.numbers(list);
  if (!numbers) return;
  const std::vector<double>& size = *numbers;
  const auto sound = [](double side) { return side >= 1 && side <= longest_side && side == std::floor(side); };
  if (size.size() == 2 && sound(size[0]) && sound(size[1]))
    result.camera.width = int(size[0]), result.camera.height = int(size[1]);
  else
    entries.complain(list, list + " must be the width and the height of the images, two whole numbers");
}

void take_depth_scale(CameraEntries& entries, const std::string& key, double metres, CameraFile& result) {
  if (!entries.has(key)) return;
  const auto scale = entries.number(
      key, least_scale / metres, largest_scale / metres,
      metres == 1 ? "metres per unit of depth.png, 0.001 for millimetres" : "millimetres per unit of the depth image");
  if (scale) result.depth_scale = *scale * metres;
}

void take_depth_factor(CameraEntries& entries, const std::string& key, CameraFile& result) {
  if (!entries.has(key)) return;
  const auto factor = entries.number(key, 1 / largest_scale, 1 / least_scale, "units of the depth image per metre");
  if (factor && *factor != 1) result.depth_scale = 1 / *factor;  // 1 is for depth in floats
}

std::optional<double> focal_height(CameraEntries& entries, const std::string& key, CameraFile& result) {
  if (entries.has(key) && entries.node(key).IsScalar())
    if (const auto value = number_of(entries.node(key).Scalar()); value && *value <= -shortest_focus) {
      result.notes.push_back(negative_fy_note);
      return std::min(-*value, longest_focus);
    }
  return entries.number(key, shortest_focus, longest_focus, "focal length in pixel heights");
}

/// Size, focal lengths, principal point and unit of depth by their names.
CameraFile read_named(CameraEntries& entries, const Names& names) {
  CameraFile result;
  Camera& camera = result.camera;
  take_size(entries, names.width, names.height, result);
  camera.fx = entries.number(names.fx, shortest_focus, longest_focus, "focal length in pixel widths").value_or(1);
  camera.fy = focal_height(entries, names.fy, result).value_or(1);
  const double width = camera.width > 0 ? camera.width : longest_side,
               height = camera.height > 0 ? camera.height : longest_side;
  camera.cx =
      entries.number(names.cx, 0, width, "column of the principal point, which must lie in the image").value_or(0);
  camera.cy =
      entries.number(names.cy, 0, height, "row of the principal point, which must lie in the image").value_or(0);
  if (!names.depth_scale.empty()) take_depth_scale(entries, names.depth_scale, 1, result);
  if (!names.depth_factor.empty()) take_depth_factor(entries, names.depth_factor, result);
  return result;
}

constexpr const char* how_to_rectify =
    "; rectify the images (image_proc of ROS, cv2.undistort) and give a camera without distortion";

/// The lens of coefficients that a model's name explains; an unknown one is refused unless all are zero.
void take_lens(CameraEntries& entries, const std::string& model_key, const std::string& coefficients_key,
               std::vector<double> coefficients, CameraFile& result) {
  const std::string model = model_key.empty() ? "" : entries.word(model_key);
  const auto is = [&](std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(), [&](const char* name) { return model.find(name) != model.npos; });
  };
  const bool zero = std::all_of(coefficients.begin(), coefficients.end(), [](double value) { return value == 0; });
  Lens lens{Lens::Model::radial_tangential, std::move(coefficients)};
  if (is({"equidistant", "fisheye", "kannala"}))
    lens.model = Lens::Model::equidistant;
  else if (zero)
    return;
  else if (is({"inverse_brown", "inverse brown"}))  // small in all cameras that have it: its first order is enough
    for (double& value : lens.coefficients) value = -value;
  else if (!model.empty() &&
           !is({"plumb_bob", "radtan", "radial", "rational", "brown", "opencv", "pinhole", "perspective"}))
    return entries.complain(model_key, "the distortion model " + shown(model) + " cannot be read" + how_to_rectify);
  const std::size_t most = lens.model == Lens::Model::equidistant ? 4 : 12;
  if (std::any_of(lens.coefficients.begin() + std::ptrdiff_t(std::min(most, lens.coefficients.size())),
                  lens.coefficients.end(), [](double value) { return value != 0; }))
    return entries.complain(coefficients_key, "more than " + std::to_string(most) +
                                                  " coefficients of distortion cannot be read" + how_to_rectify);
  result.lens = std::move(lens);
}

/// Coefficients in a list.
void take_lens_of_list(CameraEntries& entries, CameraFile& result) {
  const std::string list =
      entries.first_of({"distortion_coefficients", "Distortion_Coefficients", "distortion_coeffs", "D", "d",
                        "distCoeffs", "dist_coeffs", "distortion", "dist", "coeffs", "D1"});
  const std::string model = entries.first_of({"distortion_model", "model", "camera_model"});
  if (auto coefficients = entries.numbers(list)) take_lens(entries, model, list, *std::move(coefficients), result);
}

/// Coefficients by name: k1 to k6, p1, p2, behind a prefix.
void take_lens_of_names(CameraEntries& entries, const std::string& prefix, const std::string& model_key,
                        CameraFile& result) {
  const std::string model = entries.word(model_key);
  const bool fisheye = model.find("fisheye") != model.npos || model.find("kannala") != model.npos ||
                       model.find("equidistant") != model.npos;
  const Keys order = fisheye ? Keys{"k1", "k2", "k3", "k4"} : Keys{"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};
  std::vector<double> coefficients;
  for (const std::string& name : order)
    coefficients.push_back(if_there(entries, prefix + name, [&] {
                             return entries.number(prefix + name, -1e6, 1e6, "a coefficient of distortion");
                           }).value_or(0));
  take_lens(entries, entries.has(model_key) ? model_key : "", prefix + "k1", std::move(coefficients), result);
}

/// Where the driver gave a part of the sensor's image only.
void take_region(CameraEntries& entries, CameraFile& result) {
  if (!entries.has("roi") || !entries.node("roi").IsMap()) return;
  CameraEntries roi("", entries.node("roi"));
  const auto value = [&](const char* key) {
    return roi.has(key) ? roi.whole_number(key, 0, longest_side, "").value_or(0) : 0;
  };
  const int width = value("width"), height = value("height");
  if (width == 0 || height == 0) return;
  result.camera.width = width, result.camera.height = height;
  result.camera.cx -= value("x_offset"), result.camera.cy -= value("y_offset");
}

/// A matrix with what programs write beside it.
CameraFile read_matrix(CameraEntries& entries, const Keys& matrix_keys, double metres_per_scale) {
  CameraFile result;
  const std::string key = entries.first_of(matrix_keys);
  if (key.empty()) {
    entries.complain("", "'" + matrix_keys[0] + "' is missing: the camera's matrix, fx 0 cx, 0 fy cy, 0 0 1");
    return result;
  }
  take_any_size(entries, result);
  take_lens_of_list(entries, result);
  take_depth_scale(entries, "depth_scale", metres_per_scale, result);
  const auto numbers = entries.numbers(key);
  if (!numbers) return result;
  if (const std::string wrong = take_matrix(*numbers, result); !wrong.empty())
    return entries.complain(key, key + " " + wrong), result;
  take_region(entries, result);
  const Camera& c = result.camera;
  const auto inside = [](double centre, int size) { return centre >= 0 && (size == 0 || centre <= size); };
  if (!(c.fx >= shortest_focus && c.fx <= longest_focus && c.fy >= shortest_focus && c.fy <= longest_focus) ||
      !inside(c.cx, c.width) || !inside(c.cy, c.height))
    entries.complain(key,
                     key + " must have focal lengths from 0.01 to 1e7 pixels, and the principal point in the image");
  return result;
}

/// Four numbers in a list: fx, fy, cx, cy.
CameraFile read_kalibr(CameraEntries& entries) {
  CameraFile result;
  take_any_size(entries, result);
  const std::string model = entries.word("camera_model");
  if (!model.empty() && model != "pinhole")
    entries.complain("camera_model", "the camera model " + shown(model) + " is not a pinhole camera" + how_to_rectify);
  take_lens_of_list(entries, result);
  const auto numbers = entries.numbers("intrinsics");
  if (!numbers) return result;
  const std::vector<double>& k = *numbers;
  if (k.size() != 4 || !(k[0] >= shortest_focus) || !(k[1] >= shortest_focus))
    entries.complain("intrinsics",
                     "intrinsics must be fx, fy, cx, cy: positive focal lengths in pixels, and the principal point");
  else
    result.camera.fx = k[0], result.camera.fy = k[1], result.camera.cx = k[2], result.camera.cy = k[3];
  return result;
}

const Keys own_keys{"width", "height", "fx", "fy", "cx", "cy", "depth_scale"};
const Keys lens_keys{"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "distortion_model"};

/// Ours. What is written by hand has no other key, which may be a slip; programs write more.
CameraFile read_own(CameraEntries& entries) {
  for (const std::string& key : entries.keys()) {
    const bool known = std::find(own_keys.begin(), own_keys.end(), key) != own_keys.end() ||
                       std::find(lens_keys.begin(), lens_keys.end(), key) != lens_keys.end();
    const std::string meant = known ? "" : did_you_mean(key, own_keys);
    if (!known && (!entries.is_json() || !meant.empty()))
      entries.complain_of_key(key, "unknown key " + shown(key) + meant);
  }
  CameraFile result = read_named(entries, {"width", "height", "fx", "fy", "cx", "cy"});
  // camera.json of BOP has the same keys, but the scale in millimetres: 1 or 0.1 metres are none of a sensor.
  const auto scale = entries.has("depth_scale") && entries.node("depth_scale").IsScalar()
                         ? number_of(entries.node("depth_scale").Scalar())
                         : std::nullopt;
  const bool millimetres = entries.is_json() && scale && *scale >= 0.01;
  take_depth_scale(entries, "depth_scale", millimetres ? 0.001 : 1, result);
  take_lens_of_names(entries, "", "distortion_model", result);
  return result;
}

std::function<bool(const CameraEntries&)> has_one_of(Keys keys) {
  return [keys = std::move(keys)](const CameraEntries& entries) { return !entries.first_of(keys).empty(); };
}

/// ORB-SLAM 2 and 3 differ in the prefix.
CameraFile read_orb_slam(CameraEntries& entries) {
  const std::string prefix = entries.has("Camera1.fx") ? "Camera1." : "Camera.";
  Names names{"Camera.width", "Camera.height", prefix + "fx", prefix + "fy", prefix + "cx", prefix + "cy"};
  names.depth_factor = entries.first_of({"RGBD.DepthMapFactor", "DepthMapFactor"});
  CameraFile result = read_named(entries, names);
  take_lens_of_names(entries, prefix, "Camera.type", result);
  return result;
}

CameraFile read_realsense(CameraEntries& entries) {
  CameraFile result = read_named(entries, {"width", "height", "fx", "fy", "ppx", "ppy", "depth_scale"});
  take_lens_of_list(entries, result);
  return result;
}

CameraFile read_autolab(CameraEntries& entries) {
  if (entries.has("_skew")) entries.number("_skew", -1e-3, 1e-3, "skew of the axes, which is not supported");
  return read_named(entries, {"_width", "_height", "_fx", "_fy", "_cx", "_cy"});
}

CameraFile read_nerf(CameraEntries& entries) {
  CameraFile result = read_named(entries, {"w", "h", "fl_x", "fl_y", "cx", "cy"});
  take_lens_of_names(entries, "", "camera_model", result);
  return result;
}

/// Of a scan's text: colour's camera stands beside depth's.
CameraFile read_scannet(CameraEntries& entries) {
  return read_named(entries, {"depthWidth", "depthHeight", "fx_depth", "fy_depth", "mx_depth", "my_depth"});
}

/// The head of a .sens file as text; also of 3RScan.
CameraFile read_sens(CameraEntries& entries) {
  CameraFile result = read_matrix(entries, {"m_calibrationDepthIntrinsic"}, 1);
  take_size(entries, "m_depthWidth", "m_depthHeight", result);
  take_depth_factor(entries, "m_depthShift", result);
  return result;
}

CameraFile read_replica(CameraEntries& entries) {
  Names names{"w", "h", "fx", "fy", "cx", "cy"};
  names.depth_factor = "scale";
  return read_named(entries, names);
}

std::vector<CameraFormat> make_camera_formats() {
  const Keys ros{"camera_matrix", "K", "k"};
  const Keys opencv{"camera_matrix", "Camera_Matrix", "cameraMatrix", "K1", "M1", "mtx"};
  const Keys arkit{"intrinsics", "cameraIntrinsics", "camera_intrinsics", "intrinsic", "camera_intrinsic"};
  const auto matrix = [](const Keys& keys, double metres) {
    return [=](CameraEntries& entries) { return read_matrix(entries, keys, metres); };
  };
  return {
      {"ORB-SLAM's settings", "Camera.fx, Camera.fy, Camera.cx, Camera.cy",
       has_one_of({"Camera.fx", "Camera.fy", "Camera1.fx", "Camera1.fy"}), read_orb_slam},
      {"RealSense's intrinsics", "width, height, fx, fy, ppx, ppy", has_one_of({"ppx", "ppy"}), read_realsense},
      {"autolab's .intr", "_width, _height, _fx, _fy, _cx, _cy", has_one_of({"_fx", "_fy", "_cx", "_cy"}),
       read_autolab},
      {"Open3D's intrinsics", "width, height, intrinsic_matrix", has_one_of({"intrinsic_matrix"}),
       matrix({"intrinsic_matrix"}, 1)},
      {"BOP's camera", "cam_K, depth_scale", has_one_of({"cam_K"}), matrix({"cam_K"}, 0.001)},
      {"kalibr's camchain", "resolution, intrinsics, distortion_coeffs",
       [](const CameraEntries& entries) {
         return entries.has("intrinsics") && (entries.has("camera_model") || (entries.node("intrinsics").IsSequence() &&
                                                                              entries.node("intrinsics").size() == 4));
       },
       read_kalibr},
      {"ROS camera_info", "width, height, K, D",
       [](const CameraEntries& entries) {
         return !entries.first_of({"K", "k", "distortion_model"}).empty() && entries.first_of({"fx", "fl_x"}).empty();
       },
       matrix(ros, 1)},
      {"OpenCV's calibration", "image_width, image_height, camera_matrix, distortion_coefficients",
       has_one_of({"camera_matrix", "Camera_Matrix", "cameraMatrix", "K1", "M1", "mtx", "image_width"}),
       matrix(opencv, 1)},
      {"ARKit's intrinsics", "intrinsics (9 numbers)",
       [=](const CameraEntries& entries) {
         const std::string key = entries.first_of(arkit);
         return !key.empty() && entries.node(key).IsSequence();
       },
       matrix(arkit, 1)},
      {"ScanNet's text", "depthWidth, depthHeight, fx_depth, fy_depth, mx_depth, my_depth",
       has_one_of({"fx_depth", "fy_depth", "mx_depth", "my_depth"}), read_scannet},
      {"the text of a .sens file", "m_depthWidth, m_depthHeight, m_depthShift, m_calibrationDepthIntrinsic",
       has_one_of({"m_calibrationDepthIntrinsic", "m_depthWidth"}), read_sens},
      {"NeRF's transforms", "w, h, fl_x, fl_y, cx, cy", has_one_of({"fl_x", "fl_y"}), read_nerf},
      {"Replica's camera", "w, h, fx, fy, cx, cy, scale",
       [](const CameraEntries& entries) { return entries.has("w") && entries.has("h") && entries.has("fx"); },
       read_replica},
      {"a camera file", "width, height, fx, fy, cx, cy", has_one_of(own_keys), read_own},
  };
}

}  // namespace

std::span<const CameraFormat> camera_formats() {
  static const std::vector<CameraFormat> formats = make_camera_formats();
  return formats;
}

}  // namespace gestalt
