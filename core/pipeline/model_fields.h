// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// Reading the fields of a model that may be untrusted. Each throws ModelError, naming the key, when the
/// field is absent or is anything else than what is asked for.

/// The member of an object, of whatever type.
GESTALT_EXPORT const nlohmann::json& field(const nlohmann::json& object, const std::string& key);

/// Whether it is in [-1e100, 1e100], as all numbers of a model are, so that what is computed of it stays finite.
GESTALT_EXPORT bool is_model_number(double value);

/// A number in [-1e100, 1e100].
GESTALT_EXPORT double number_field(const nlohmann::json& object, const std::string& key);

/// A list of such numbers.
GESTALT_EXPORT std::vector<double> numbers_field(const nlohmann::json& object, const std::string& key);

/// A list of integers in [low, high].
GESTALT_EXPORT std::vector<int> integers_field(const nlohmann::json& object, const std::string& key, int low, int high);

/// A text.
GESTALT_EXPORT std::string text_field(const nlohmann::json& object, const std::string& key);

/// A list of texts.
GESTALT_EXPORT std::vector<std::string> texts_field(const nlohmann::json& object, const std::string& key);

/// A count: a non-negative integer.
GESTALT_EXPORT std::size_t count_field(const nlohmann::json& object, const std::string& key);

}  // namespace gestalt
