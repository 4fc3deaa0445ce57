// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>

namespace gestalt::app {

/// A number from least to most; a whole one where they are. CLI::Range lets nan pass, and the options of unsigned
/// numbers take -1 and what is too large for the largest.
template <class Number>
CLI::Validator number_in(Number least, Number most) {
  std::ostringstream limits;
  limits << least << " to " << most;
  CLI::Validator check(
      [=, range = limits.str()](std::string& text) -> std::string {
        const std::size_t sign = text.starts_with('+') ? 1 : 0;
        Number value{};
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data() + sign, end, value);
        if (error == std::errc() && stop == end && value >= least && value <= most) return "";
        return "'" + text + "' is not a " + (std::is_integral_v<Number> ? "whole number" : "number") + " from " + range;
      },
      "", "number");
  std::ostringstream description;
  description << CLI::detail::type_name<Number>() << " in [" << least << " - " << most << "]";
  return check.description(description.str());
}

/// The seed of a random order.
inline CLI::Validator seed_number() {
  return number_in<std::uint64_t>(0, std::numeric_limits<std::uint64_t>::max()).description("");
}

}  // namespace gestalt::app
