// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "wording.h"

#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "text.h"

namespace gestalt::python {

namespace {

/// An option of the command, and the argument that takes its word.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> arguments{
    {{"--depth-kind ", "depth_kind"}, {"--labels ", "labels"}, {"--config ", "config"}}};

}  // namespace

std::string in_python(const std::string& message) {
  std::string words;
  std::set<std::string> told;
  const auto tell = [&](const std::string& argument) {
    if (told.insert(argument).second) words += (words.empty() ? "" : ", ") + argument;
  };
  if (message.find("--unit") != message.npos) tell("depth_scale=, the metres of a unit");
  for (const auto& [option, argument] : arguments)
    for (std::size_t at = 0; (at = message.find(option, at)) != message.npos;) {
      at += option.size();
      const std::size_t end = message.find_first_not_of("abcdefghijklmnopqrstuvwxyz_.", at);
      std::string value = message.substr(at, end == message.npos ? end : end - at);
      if (value.ends_with('.')) value.pop_back();
      if (!value.empty()) tell(std::string(argument) + "=\"" + value + "\"");
    }
  return words.empty() ? message : message + " (in Python: " + words + ")";
}

void warn(const std::string& message) {
  if (PyErr_WarnFormat(PyExc_UserWarning, 1, "%U", text_of(message).ptr())) throw pybind11::error_already_set();
}

void warn(const std::vector<std::string>& messages) {
  std::set<std::string> told;
  for (const std::string& message : messages)
    if (told.insert(message).second) warn(in_python(message));
}

}  // namespace gestalt::python
