// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>

#include "camera_formats.h"
#include "gestalt/core/base/error.h"
#include "header_line.h"
#include "words.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

/// A line with its number, counted from 1, without what follows a #.
struct Line {
  int number;
  std::vector<std::string_view> words;
};

/// Those that are not empty, at most so many.
std::vector<Line> lines_of(std::string_view text, std::size_t most) {
  std::vector<Line> lines;
  for (int number = 1; !text.empty() && lines.size() < most; ++number) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    auto words = words_of(line.substr(0, line.find('#')));
    if (!words.empty()) lines.push_back({number, std::move(words)});
  }
  return lines;
}

[[noreturn]] void fail_at(const fs::path& file, int line, const std::string& what) {
  throw InputError(file.string() + ":" + std::to_string(line) + ": " + what);
}

/// Numbers alone, with whatever brackets and separators; empty when anything else is there.
std::vector<double> plain_numbers(std::string_view text) {
  constexpr std::size_t most = 16, most_lines = 64;
  std::vector<double> numbers;
  for (const Line& line : lines_of(text, most_lines))
    for (const std::string_view word : line.words) {
      std::string spaced(word);
      // A decimal comma has digits on both sides; any other separates.
      if (!number_of(word)) std::replace(spaced.begin(), spaced.end(), ',', ' ');
      for (const char bracket : {'[', ']', '(', ')', ';'}) std::replace(spaced.begin(), spaced.end(), bracket, ' ');
      for (const std::string_view part : words_of(spaced)) {
        const auto value = number_of(part);
        if (!value || numbers.size() == most) return {};
        numbers.push_back(*value);
      }
    }
  return numbers;
}

bool is_matrix(std::string_view text) {
  const std::size_t count = plain_numbers(text).size();
  return count == 9 || count == 12 || count == 16;
}

CameraFile read_matrix_text(const fs::path& file, std::string_view text) {
  CameraFile result;
  if (const std::string wrong = take_matrix(plain_numbers(text), result); !wrong.empty())
    fail_at(file, 1, "the matrix " + wrong);
  return result;
}

bool is_six(std::string_view text) { return plain_numbers(text).size() == 6; }

/// Width, height, fx, fy, cx, cy.
CameraFile read_pincam(const fs::path& file, std::string_view text) {
  constexpr double longest_side = 1 << 20;
  const std::vector<double> n = plain_numbers(text);
  const auto is_side = [](double side) { return side >= 1 && side <= longest_side && side == std::floor(side); };
  if (!is_side(n[0]) || !is_side(n[1]))
    fail_at(file, 1,
            "six numbers must be width, height, fx, fy, cx and cy; the first two are not the size of an image");
  return Camera{int(n[0]), int(n[1]), n[2], n[3], n[4], n[5]};
}

bool is_four_or_eight(std::string_view text) {
  const std::size_t count = plain_numbers(text).size();
  return count == 4 || count == 8;
}

/// fx, fy, cx, cy, and perhaps k1, k2, p1, p2.
CameraFile read_four(const fs::path&, std::string_view text) {
  const std::vector<double> n = plain_numbers(text);
  CameraFile result(Camera{0, 0, n[0], n[1], n[2], n[3]});
  if (n.size() == 8) result.lens = Lens{Lens::Model::radial_tangential, {n.begin() + 4, n.end()}};
  return result;
}

/// COLMAP's camera models: how many focal lengths they have, and how their coefficients are those of a lens.
struct ColmapModel {
  std::string_view name;
  std::size_t focal_lengths;
  Lens::Model lens;
  std::size_t coefficients;
};

constexpr std::array<ColmapModel, 9> colmap_models{{{"SIMPLE_PINHOLE", 1, Lens::Model::radial_tangential, 0},
                                                    {"PINHOLE", 2, Lens::Model::radial_tangential, 0},
                                                    {"SIMPLE_RADIAL", 1, Lens::Model::radial_tangential, 1},
                                                    {"RADIAL", 1, Lens::Model::radial_tangential, 2},
                                                    {"OPENCV", 2, Lens::Model::radial_tangential, 4},
                                                    {"FULL_OPENCV", 2, Lens::Model::radial_tangential, 8},
                                                    {"OPENCV_FISHEYE", 2, Lens::Model::equidistant, 4},
                                                    {"SIMPLE_RADIAL_FISHEYE", 1, Lens::Model::equidistant, 1},
                                                    {"RADIAL_FISHEYE", 1, Lens::Model::equidistant, 2}}};

const ColmapModel* colmap_model(const Line& line) {
  if (line.words.size() < 5) return nullptr;
  const auto found = std::find_if(colmap_models.begin(), colmap_models.end(),
                                  [&](const ColmapModel& model) { return model.name == line.words[1]; });
  return found == colmap_models.end() ? nullptr : &*found;
}

bool is_colmap(std::string_view text) {
  const std::vector<Line> lines = lines_of(text, 1);
  return !lines.empty() && colmap_model(lines[0]);
}

CameraFile read_colmap(const fs::path& file, std::string_view text) {
  constexpr double longest_side = 1 << 20;
  const std::vector<Line> lines = lines_of(text, 2);
  const Line& line = lines[0];
  if (lines.size() > 1)
    fail_at(file, lines[1].number, "a second camera; put the camera of these images in its own file");
  const ColmapModel& model = *colmap_model(line);
  std::vector<double> numbers;
  for (std::size_t i = 2; i < line.words.size(); ++i) {
    const auto value = number_of(line.words[i]);
    if (!value) fail_at(file, line.number, shown(line.words[i]) + " is not a number");
    numbers.push_back(*value);
  }
  const std::size_t expected = 2 + model.focal_lengths + 2 + model.coefficients;
  if (numbers.size() != expected)
    fail_at(file, line.number,
            std::string(model.name) + " has " + std::to_string(expected) +
                " numbers, width and height included; here are " + std::to_string(numbers.size()));
  const auto is_side = [](double side) { return side >= 1 && side <= longest_side && side == std::floor(side); };
  if (!is_side(numbers[0]) || !is_side(numbers[1]))
    fail_at(file, line.number, "width and height must be whole numbers");
  const std::size_t centre = 2 + model.focal_lengths;
  // COLMAP's (0, 0) is the corner of the first pixel, ours its centre.
  CameraFile result(Camera{int(numbers[0]), int(numbers[1]), numbers[2], numbers[centre - 1], numbers[centre] - 0.5,
                           numbers[centre + 1] - 0.5});
  result.lens = Lens{model.lens, {numbers.begin() + std::ptrdiff_t(centre + 2), numbers.end()}};
  return result;
}

}  // namespace

std::span<const CameraTextFormat> camera_text_formats() {
  static const std::array<CameraTextFormat, 4> formats{
      {{"COLMAP's cameras.txt", "CAMERA_ID MODEL WIDTH HEIGHT PARAMS", is_colmap, read_colmap},
       {"a matrix as text", "3x3, 3x4 or 4x4 numbers", is_matrix, read_matrix_text},
       {"ARKitScenes' .pincam", "width height fx fy cx cy", is_six, read_pincam},
       {"four numbers", "fx fy cx cy (k1 k2 p1 p2)", is_four_or_eight, read_four}}};
  return formats;
}

}  // namespace gestalt
