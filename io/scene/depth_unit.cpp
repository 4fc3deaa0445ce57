// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/depth_unit.h"

#include <array>
#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>
#include <utility>

#include "scene_camera.h"

namespace gestalt {

namespace {

constexpr std::array<std::pair<std::string_view, double>, 6> units{
    {{"um", 1e-6}, {"mm", 1e-3}, {"cm", 1e-2}, {"dm", 0.1}, {"km", 1e3}, {"m", 1}}};

std::string plain(double number) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(6);
  text << number;
  return text.str();
}

}  // namespace

std::optional<double> metres_of_unit(std::string_view text) {
  double factor = 1;
  const char* const end = text.data() + text.size();
  if (const auto [after, error] = std::from_chars(text.data(), end, factor); error == std::errc{})
    text.remove_prefix(std::size_t(after - text.data()));
  else
    factor = 1;
  while (text.starts_with(' ')) text.remove_prefix(1);
  for (const auto& [name, metres] : units)
    if (text == name && factor * metres >= 1e-9 && factor * metres <= 1e4) return factor * metres;
  return std::nullopt;
}

std::string unit_name(double metres) {
  for (const auto& [name, length] : {units[5], units[2], units[1], units[0]})
    if (std::abs(metres - length) < 1e-6 * length) return std::string(name);
  return metres >= 0.1 ? plain(metres) + " m" : plain(1000 * metres) + " mm";
}

std::string text(const DepthUnit& unit) { return plain(unit.metres) + " m, " + unit.from; }

DepthUnit unit_of_whole_numbers(const ReadOptions& options, const std::optional<CameraFile>& camera) {
  if (options.depth_scale) return {*options.depth_scale, "as given", true};
  if (camera && camera->depth_scale) return {*camera->depth_scale, camera_name(*camera), false};
  return {0.001, "the default for whole numbers", false};
}

DepthUnit unit_of_floats(const ReadOptions& options) {
  if (options.depth_scale) return {*options.depth_scale, "as given", true};
  return {1, "the default for floats and clouds", false};
}

}  // namespace gestalt
