// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

#include "gestalt/core/plugin/classifier.h"
#include "gestalt/core/plugin/clusterer.h"
#include "gestalt/core/plugin/fitter.h"
#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"
#include "gestalt/core/plugin/solver.h"

namespace gestalt {

/// Makes components of one kind from parameter values.
template <class Kind>
struct Factory {
  std::vector<Parameter> parameters;
  std::function<std::unique_ptr<Kind>(const ParameterValues&)> create;
};

/// The word for a kind in configs, manifests and messages.
template <class Kind>
inline constexpr const char* kind_name = nullptr;
template <>
inline constexpr const char* kind_name<Clusterer> = "clusterer";
template <>
inline constexpr const char* kind_name<Fitter> = "fitter";
template <>
inline constexpr const char* kind_name<Relation> = "relation";
template <>
inline constexpr const char* kind_name<Classifier> = "classifier";
template <>
inline constexpr const char* kind_name<Solver> = "solver";

/// All of them in the order of the method, from pixels to objects.
inline constexpr std::array<const char*, 5> kind_names{kind_name<Clusterer>, kind_name<Fitter>, kind_name<Relation>,
                                                       kind_name<Classifier>, kind_name<Solver>};

namespace detail {
template <class Component, class... Kinds>
struct FirstBase;
template <class Component, class Kind, class... Rest>
struct FirstBase<Component, Kind, Rest...> {
  using type = typename std::conditional_t<std::is_base_of_v<Kind, Component>, std::type_identity<Kind>,
                                           FirstBase<Component, Rest...>>::type;
};
}  // namespace detail

/// The kind that a component class derives from.
template <class Component>
using KindOf = typename detail::FirstBase<Component, Clusterer, Fitter, Relation, Classifier, Solver>::type;

}  // namespace gestalt
