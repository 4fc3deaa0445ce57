// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "times.h"

#include <iomanip>
#include <sstream>

namespace gestalt::bench {

namespace {

constexpr int name_width = 16;
constexpr int number_width = 9;

}  // namespace

nlohmann::ordered_json spread(const std::vector<double>& values) {
  return {{"median", median(values)},
          {"p95", quantile(values, 0.95)},
          {"p99", quantile(values, 0.99)},
          {"worst", quantile(values, 1)}};
}

std::string cell(double number) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << std::setw(number_width) << number;
  return text.str();
}

std::string cell(const std::string& word) {
  std::ostringstream text;
  text << std::setw(number_width) << word;
  return text.str();
}

std::string row(const std::string& name, const nlohmann::ordered_json& spread) {
  std::ostringstream line;
  line << std::left << std::setw(name_width) << name;
  for (const auto& value : spread) line << cell(value.get<double>());
  return line.str();
}

std::string heading(const std::string& name) {
  std::ostringstream line;
  line << std::left << std::setw(name_width) << name;
  for (const char* column : {"median", "p95", "p99", "worst"}) line << cell(std::string(column));
  return line.str();
}

}  // namespace gestalt::bench
