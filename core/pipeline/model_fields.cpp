// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/pipeline/model_fields.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "gestalt/core/base/error.h"

namespace gestalt {

using nlohmann::json;

namespace {

// Far above anything that training gives, and small enough that no sum or product of three such numbers overflows.
constexpr double largest = 1e100;

[[noreturn]] void fail(const std::string& key, const std::string& expected) {
  throw ModelError("'" + key + "' must be " + expected);
}

const json& list(const json& object, const std::string& key, const std::string& expected) {
  const json& value = field(object, key);
  if (!value.is_array()) fail(key, expected);
  return value;
}

bool is_bounded_number(const json& value) { return value.is_number() && is_model_number(value.get<double>()); }

}  // namespace

bool is_model_number(double value) { return std::abs(value) <= largest; }

const json& field(const json& object, const std::string& key) {
  if (!object.is_object()) throw ModelError("expected an object with the key '" + key + "'");
  const auto found = object.find(key);
  if (found == object.end()) throw ModelError("the key '" + key + "' is missing");
  return *found;
}

double number_field(const json& object, const std::string& key) {
  const json& value = field(object, key);
  if (!is_bounded_number(value)) fail(key, "a number in [-1e100, 1e100]");
  return value.get<double>();
}

std::vector<double> numbers_field(const json& object, const std::string& key) {
  const std::string expected = "a list of numbers in [-1e100, 1e100]";
  std::vector<double> numbers;
  for (const json& value : list(object, key, expected)) {
    if (!is_bounded_number(value)) fail(key, expected);
    numbers.push_back(value.get<double>());
  }
  return numbers;
}

std::vector<int> integers_field(const json& object, const std::string& key, int low, int high) {
  const std::string expected = "a list of integers in [" + std::to_string(low) + ", " + std::to_string(high) + "]";
  std::vector<int> integers;
  for (const json& value : list(object, key, expected)) {
    // Compared as a double, which holds every value that an int can have, and orders all others right.
    if (!value.is_number_integer() || value.get<double>() < low || value.get<double>() > high) fail(key, expected);
    integers.push_back(value.get<int>());
  }
  return integers;
}

std::string text_field(const json& object, const std::string& key) {
  const json& value = field(object, key);
  if (!value.is_string()) fail(key, "a text");
  return value.get<std::string>();
}

std::vector<std::string> texts_field(const json& object, const std::string& key) {
  const std::string expected = "a list of strings";
  std::vector<std::string> texts;
  for (const json& value : list(object, key, expected)) {
    if (!value.is_string()) fail(key, expected);
    texts.push_back(value.get<std::string>());
  }
  return texts;
}

std::size_t count_field(const json& object, const std::string& key) {
  const json& value = field(object, key);
  if (!value.is_number_unsigned()) fail(key, "a non-negative integer");
  return value.get<std::size_t>();
}

}  // namespace gestalt
