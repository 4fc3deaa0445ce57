// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/parameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <sstream>

#include "gestalt/core/base/suggest.h"

namespace gestalt {

namespace {

std::string number_text(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

bool in_range(const Parameter& d, double value) { return value >= d.minimum && value <= d.maximum; }

std::string expectation(const Parameter& d) {
  std::string text = "expected ";
  switch (d.type) {
    case Parameter::Type::boolean:
      return text + "true or false";
    case Parameter::Type::integer:
      text += "an integer";
      break;
    case Parameter::Type::real:
      text += "a number";
      break;
    case Parameter::Type::choice:
      return text + "one of " + range_text(d);
  }
  const std::string range = range_text(d);
  if (!range.empty()) text += " in " + range;
  return d.unit.empty() ? text : text + " " + d.unit;
}

[[noreturn]] void fail(const Parameter& d, const std::string& got) {
  std::string message = expectation(d) + ", got '" + got + "'";
  if (d.type == Parameter::Type::choice) message += did_you_mean(got, d.choices);
  throw ConfigError(message);
}

template <class Number>
Number parse_number(const Parameter& d, std::string_view text) {
  Number value{};
  const char* begin = text.data();
  const char* end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || stop != end) fail(d, std::string(text));
  if (!std::isfinite(double(value)) || !in_range(d, double(value))) fail(d, std::string(text));
  return value;
}

void check(const Parameter& d, const ParameterValue& value) {
  const bool right_type = value.index() == d.default_value.index();
  bool right = right_type;
  if (right_type && d.type == Parameter::Type::integer) right = in_range(d, double(std::get<std::int64_t>(value)));
  if (right_type && d.type == Parameter::Type::real)
    right = std::isfinite(std::get<double>(value)) && in_range(d, std::get<double>(value));
  if (right_type && d.type == Parameter::Type::choice)
    right = std::find(d.choices.begin(), d.choices.end(), std::get<std::string>(value)) != d.choices.end();
  if (!right) throw ConfigError(d.name + ": " + expectation(d) + ", got '" + to_string(value) + "'");
}

}  // namespace

ParameterValue parse_parameter(const Parameter& d, std::string_view text) {
  switch (d.type) {
    case Parameter::Type::boolean:
      if (text == "true" || text == "on" || text == "yes") return true;
      if (text == "false" || text == "off" || text == "no") return false;
      fail(d, std::string(text));
    case Parameter::Type::integer:
      return parse_number<std::int64_t>(d, text);
    case Parameter::Type::real:
      return parse_number<double>(d, text);
    case Parameter::Type::choice:
      if (std::find(d.choices.begin(), d.choices.end(), text) == d.choices.end()) fail(d, std::string(text));
      return std::string(text);
  }
  fail(d, std::string(text));
}

std::string to_string(const ParameterValue& value) {
  struct Text {
    std::string operator()(bool v) const { return v ? "true" : "false"; }
    std::string operator()(std::int64_t v) const { return std::to_string(v); }
    std::string operator()(double v) const { return number_text(v); }
    std::string operator()(const std::string& v) const { return v; }
  };
  return std::visit(Text{}, value);
}

std::string to_string(Parameter::Type type) {
  switch (type) {
    case Parameter::Type::boolean:
      return "boolean";
    case Parameter::Type::integer:
      return "integer";
    case Parameter::Type::real:
      return "real";
    case Parameter::Type::choice:
      return "choice";
  }
  return "";
}

std::string range_text(const Parameter& d) {
  if (d.type == Parameter::Type::choice) {
    std::string text;
    for (const std::string& word : d.choices) text += (text.empty() ? "" : " | ") + word;
    return text;
  }
  if (d.type == Parameter::Type::boolean || (std::isinf(d.minimum) && std::isinf(d.maximum))) return "";
  // The bounds of an integer are written out: 1000000, not 1e+06.
  const auto bound = [&](double value) {
    const bool whole = d.type == Parameter::Type::integer && std::abs(value) < 1e15;
    return whole ? std::to_string(std::int64_t(value)) : number_text(value);
  };
  return "[" + bound(d.minimum) + ", " + bound(d.maximum) + "]";
}

ParameterValues complete(const std::vector<Parameter>& declarations, const ParameterValues& given) {
  std::vector<std::string> names;
  ParameterValues values;
  for (const Parameter& d : declarations) {
    names.push_back(d.name);
    const auto found = given.find(d.name);
    values[d.name] = found == given.end() ? d.default_value : found->second;
    check(d, values[d.name]);
  }
  for (const auto& [name, value] : given)
    if (!values.contains(name)) throw ConfigError("unknown parameter '" + name + "'" + did_you_mean(name, names));
  return values;
}

}  // namespace gestalt
