// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fstream>
#include <iterator>

#include "gestalt/core/base/error.h"
#include "gestalt/inspector/inspection/inspection.h"

namespace gestalt {

using nlohmann::json;

namespace {

constexpr const char* place_of_scenes = "<!--scenes-->";

std::string read_template() {
  const std::filesystem::path file = data_directory() / "inspector" / "inspector.html";
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in || text.find(place_of_scenes) == std::string::npos)
    throw ConfigError(file.string() + ": does not exist or is not a page of the Inspector; reinstall Gestalt");
  return text;
}

/// As data of a script element, which ends nowhere but where it should: no "<" is left in it.
std::string data(const std::string& id, const json& content) {
  std::string text = content.dump(-1, ' ', true, json::error_handler_t::replace);
  for (std::size_t at = 0; (at = text.find('<', at)) != text.npos;) text.replace(at, 1, "\\u003c");
  return "<script type=\"application/json\" id=\"" + id + "\">" + text + "</script>\n";
}

/// The picture that a scene is first seen by is an element of its own, as a browser shows it before it has read the
/// rest.
std::string picture(std::size_t number, const json& scene) {
  const json& uri = scene.at("images").at("colour");
  if (uri.is_null()) return "";
  return "<img id=\"picture-" + std::to_string(number) + "\"" + (number > 0 ? " hidden" : "") +
         " alt=\"\" elementtiming=\"picture\" src=\"" + uri.get<std::string>() + "\">\n";
}

}  // namespace

std::string inspector_page(std::vector<json> scenes) {
  std::string page = read_template();
  json names = json::array();
  for (const json& scene : scenes) names.push_back(scene.at("name"));
  std::string all;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    all += picture(i, scenes[i]);
    scenes[i]["images"].erase("colour");
    all += data("scene-" + std::to_string(i), scenes[i]);
  }
  all += data("scenes", names);
  page.replace(page.find(place_of_scenes), std::string(place_of_scenes).size(), all);
  return page;
}

}  // namespace gestalt
