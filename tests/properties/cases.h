// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "gestalt/core/base/error.h"
#include "gestalt/core/plugin/factory.h"
#include "gestalt/core/plugin/registry.h"

namespace gestalt::properties {

/// Random choices of one case.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}

  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  bool one_in(int n) { return whole(1, n) == 1; }

  template <class T>
  const T& one_of(const std::vector<T>& things) {
    return things[std::size_t(whole(0, int(things.size()) - 1))];
  }

 private:
  std::mt19937_64 engine_;
};

/// Calls work for 10,000 cases, each with a seed of its own, which failures tell: fewer under a sanitizer, or as many
/// as GESTALT_PROPERTY_CASES says, or only that of GESTALT_PROPERTY_SEED. Ends after the first case that fails.
void for_each_case(const std::function<void(Chance&)>& work);

/// All plugins of this build.
const Registry& registry();

/// Complete parameters of a component: mostly the defaults, else some of them arbitrary in their declared ranges.
ParameterValues any_params(Chance& chance, const std::string& kind, const std::string& name);

/// A component with any_params(), or its defaults where they do not go together.
template <class Kind>
std::shared_ptr<const Kind> any_component(Chance& chance, const std::string& name) {
  try {
    return registry().create<Kind>(name, any_params(chance, kind_name<Kind>, name));
  } catch (const ConfigError&) {
    return registry().create<Kind>(name, {});
  }
}

}  // namespace gestalt::properties
