// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cases.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#ifdef GESTALT_UNDER_SANITIZER
#include <sanitizer/common_interface_defs.h>
#endif

#include "gestalt/core/plugin/parameters.h"

namespace gestalt::properties {

namespace {

#ifdef GESTALT_UNDER_SANITIZER
constexpr std::uint64_t usual_cases = 100;
#else
constexpr std::uint64_t usual_cases = 10'000;
#endif

volatile std::uint64_t seed_at_work = 0;

void tell_seed() {
  std::array<char, 80> line{};
  const int length = std::snprintf(line.data(), line.size(), "again: GESTALT_PROPERTY_SEED=%llu\n",
                                   static_cast<unsigned long long>(seed_at_work));
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, line.data(), std::size_t(length));
}

/// googletest's traces are lost then.
void tell_seed_when_it_crashes() {
#ifdef GESTALT_UNDER_SANITIZER
  __sanitizer_set_death_callback(tell_seed);
#else
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    std::signal(signal, [](int received) {
      tell_seed();
      std::signal(received, SIG_DFL);
      std::raise(received);
    });
#endif
}

std::uint64_t number(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

double number_in(Chance& chance, double low, double high) {
  low = std::max(low, -1e6);
  high = std::min(high, 1e6);
  return chance.one_in(4) ? low : chance.one_in(3) ? high : chance.real(low, high);
}

ParameterValue any_value(Chance& chance, const Parameter& parameter) {
  switch (parameter.type) {
    case Parameter::Type::boolean:
      return chance.one_in(2);
    case Parameter::Type::choice:
      return chance.one_of(parameter.choices);
    case Parameter::Type::integer:
      return std::int64_t(std::floor(number_in(chance, parameter.minimum, parameter.maximum)));
    default:
      return number_in(chance, parameter.minimum, parameter.maximum);
  }
}

}  // namespace

void for_each_case(const std::function<void(Chance&)>& work) {
  tell_seed_when_it_crashes();
  const std::uint64_t first = number("GESTALT_PROPERTY_SEED", 1);
  const std::uint64_t count = number("GESTALT_PROPERTY_CASES", std::getenv("GESTALT_PROPERTY_SEED") ? 1 : usual_cases);
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    seed_at_work = seed;
    SCOPED_TRACE("again: GESTALT_PROPERTY_SEED=" + std::to_string(seed));
    Chance chance(seed);
    work(chance);
    if (testing::Test::HasFailure()) return;
  }
}

const Registry& registry() {
  static const Registry registry(plugin_search_path({}));
  return registry;
}

ParameterValues any_params(Chance& chance, const std::string& kind, const std::string& name) {
  const std::vector<Parameter>& declared = registry().parameters(kind, name);
  ParameterValues values = complete(declared, {});
  if (!chance.one_in(8)) return values;
  for (const Parameter& parameter : declared)
    if (chance.one_in(3)) values[parameter.name] = any_value(chance, parameter);
  return values;
}

}  // namespace gestalt::properties
