// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/ground_truth.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>

#include "coco_labels.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/pipeline/learning_set.h"
#include "label_scheme.h"
#include "natural_order.h"
#include "png_file.h"
#include "scene_camera.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_colours = 1000;  // more are those of a photograph

/// One of the two kinds of PNG images that have one number a pixel.
bool is_grey(const fs::path& png) {
  constexpr int colour_type = 25;  // byte of the header
  std::error_code error;
  if (!fs::is_regular_file(png, error))
    return false;  // opening a pipe would wait for its writer; its reader reports that
  std::ifstream file(png, std::ios::binary);
  char header[colour_type + 1] = {};
  return file.read(header, sizeof header) && header[colour_type] == 0;
}

/// The number of a colour; black is 0.
int number_of(const cv::Vec3b& colour) { return colour[2] << 16 | colour[1] << 8 | colour[0]; }

cv::Mat_<int> numbers_of(const cv::Mat& image) {
  cv::Mat_<int> numbers;
  if (image.channels() == 1) {
    image.convertTo(numbers, CV_32S);
    return numbers;
  }
  numbers.create(image.size());
  std::transform(image.begin<cv::Vec3b>(), image.end<cv::Vec3b>(), numbers.begin(), number_of);
  return numbers;
}

bool has_colours(const cv::Mat& image) {
  return image.channels() == 3 && std::any_of(image.begin<cv::Vec3b>(), image.end<cv::Vec3b>(),
                                              [](const cv::Vec3b& c) { return c[0] != c[1] || c[1] != c[2]; });
}

/// Colours as numbers of objects: 0 for black or, where that is requested, for the commonest, which is where the table
/// is.
cv::Mat_<int> objects_of_colours(cv::Mat_<int> colours, const cv::Mat& measured, LabelScheme scheme) {
  std::map<int, int> pixels;
  for (int v = 0; v < colours.rows; ++v)
    for (int u = 0; u < colours.cols; ++u)
      if (measured.at<std::uint8_t>(v, u)) ++pixels[colours(v, u)];
  if (pixels.size() > most_colours)
    throw InputError(
        "has " + std::to_string(pixels.size()) +
        " colours, like a photograph; save the objects' numbers, or one colour for each object, in a lossless format");
  if (scheme == LabelScheme::osd)
    throw InputError("has colours, not the numbers of --labels osd; omit that option, or give --labels colours");
  int background = 0;
  if (scheme == LabelScheme::colours) {
    const auto commonest = std::max_element(pixels.begin(), pixels.end(),
                                            [](const auto& a, const auto& b) { return a.second < b.second; });
    if (commonest != pixels.end()) background = commonest->first;
  } else if (scheme == LabelScheme::guess && !pixels.contains(0)) {
    throw InputError("has " + std::to_string(pixels.size()) +
                     " colours, and black, which would be the background, is not among them; give --labels colours if "
                     "the commonest is the background");
  }
  std::map<int, int> objects{{background, 0}};
  for (int& colour : colours) colour = objects.emplace(colour, int(objects.size())).first->second;
  return colours;
}

void check_size(cv::Size size, const cv::Mat& measured) {
  if (size != measured.size())
    throw InputError("is " + text(size) + ", depth is " + text(measured.size()) +
                     "; the labels must have the same size");
}

/// Each file is the mask of an object, not 0 inside.
cv::Mat_<int> read_masks(const fs::path& folder, const cv::Mat& measured) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".png") files.push_back(entry.path());
  if (files.empty()) throw InputError("contains no PNG image");
  std::sort(files.begin(), files.end(),
            [](const fs::path& a, const fs::path& b) { return natural_less(a.string(), b.string()); });
  cv::Mat_<int> objects(measured.size(), 0);
  int object = 0;
  for (const fs::path& file : files) {
    const cv::Mat_<int> mask = numbers_of(is_grey(file) ? cv::Mat(read_label_png(file)) : read_colour_png(file));
    check_size(mask.size(), measured);
    objects.setTo(++object, mask != 0);
  }
  return objects;
}

void read_label_image(Input& input, const fs::path& file, const cv::Mat& measured, LabelScheme scheme) {
  const cv::Mat image = is_grey(file) ? cv::Mat(read_label_png(file)) : read_colour_png(file);
  check_size(image.size(), measured);
  if (has_colours(image)) {
    set_ground_truth(input, objects_of_colours(numbers_of(image), measured, scheme), measured, LabelScheme::objects,
                     file.string());
    if (scheme == LabelScheme::guess)
      input.notes.emplace_back("each colour of label.png is taken as an object, black as background");
    return;
  }
  cv::Mat numbers = image;
  if (image.channels() == 3) cv::extractChannel(image, numbers, 0);
  set_ground_truth(input, numbers_of(numbers), measured, scheme, file.string());
}

/// The first that is there.
std::optional<fs::path> find(const fs::path& folder, std::initializer_list<const char*> names) {
  std::error_code error;
  for (const char* name : names)
    if (fs::exists(folder / name, error)) return folder / name;
  return std::nullopt;
}

}  // namespace

void set_ground_truth(Input& input, const cv::Mat_<int>& labels, const cv::Mat& measured, LabelScheme scheme,
                      const std::string& source) try {
  if (labels.empty()) return;
  check_size(labels.size(), measured);
  const bool guessed = scheme == LabelScheme::guess;
  if (guessed) {
    const auto found = guess_scheme(labels, measured);
    if (!found)
      throw InputError(
          "its numbers may be objects numbered from 1, or the scheme of the OSD (1 to 9 background, 20 to 29 the first "
          "object, ...); give --labels objects or --labels osd");
    scheme = *found;
  }
  if (scheme == LabelScheme::osd) {
    labels.convertTo(input.ground_truth, CV_16U);
    return;
  }
  input.ground_truth = labels_of_numbers(labels, measured);
  if (guessed && count_objects(input.ground_truth) > 0)
    input.notes.emplace_back("labels are taken as objects numbered from 1, 0 as background (--labels objects)");
} catch (const InputError& error) {
  input.ground_truth.release();
  input.ground_truth_problem = source + ": " + error.what();
}

void read_ground_truth_beside(Input& input, const fs::path& folder, const cv::Mat& measured, LabelScheme scheme) {
  const auto label = find(folder, {"label.png"});
  const auto masks = find(folder, {"masks", "mask_visib", "mask"});
  const auto instances = find(folder, {"coco.json", "annotations.json", "instances.json"});
  const fs::path source = label.value_or(masks.value_or(instances.value_or(fs::path())));
  if (source.empty()) return;
  try {
    if (label)
      read_label_image(input, *label, measured, scheme);
    else
      set_ground_truth(input,
                       masks ? read_masks(*masks, measured) : read_coco_labels(*instances, measured.size(), "rgb"),
                       measured, LabelScheme::objects, source.string());
  } catch (const std::exception& error) {
    const std::string what = error.what();
    input.ground_truth_problem = what.starts_with(source.string()) ? what : source.string() + ": " + what;
  }
  if (!input.ground_truth_problem.empty() && input.ground_truth_problem.find("--labels") == std::string::npos)
    input.warnings.push_back(input.ground_truth_problem + ". The scene is treated as having no ground truth");
}

const cv::Mat_<std::uint16_t>& require_ground_truth(const Input& input) {
  if (!input.ground_truth_problem.empty()) throw InputError(input.ground_truth_problem);
  if (input.ground_truth.empty())
    throw InputError(input.path.string() +
                     ": has no ground truth; give scenes with label.png, masks/ or coco.json, or clouds or arrays with "
                     "labels");
  return input.ground_truth;
}

}  // namespace gestalt
