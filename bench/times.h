// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gestalt/core/base/quantile.h"

namespace gestalt::bench {

/// How long work takes, in milliseconds.
template <class Work>
double milliseconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

inline double median(const std::vector<double>& values) { return quantile(values, 0.5); }

/// {"median", "p95", "p99", "worst"} of at least one value.
nlohmann::ordered_json spread(const std::vector<double>& values);

/// A number in a column of a table, and the words above columns.
std::string cell(double number);
std::string cell(const std::string& word);

/// A line "name median p95 p99 worst" of a table, and the line above the table.
std::string row(const std::string& name, const nlohmann::ordered_json& spread);
std::string heading(const std::string& name);

}  // namespace gestalt::bench
