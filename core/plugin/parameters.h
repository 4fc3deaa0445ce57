// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gestalt/core/base/error.h"

namespace gestalt {

using ParameterValue = std::variant<bool, std::int64_t, double, std::string>;
using ParameterValues = std::map<std::string, ParameterValue>;

/// One declared parameter: parsing, validation, `plugins describe` and the config schema all come from this.
struct Parameter {
  enum class Type { boolean, integer, real, choice };

  std::string name;
  Type type;
  ParameterValue default_value;  ///< alternative of the variant that belongs to type (choice: std::string)
  double minimum = -std::numeric_limits<double>::infinity();  ///< integer and real: inclusive range
  double maximum = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices;  ///< choice: the allowed words
  std::string unit;                  ///< "" when dimensionless
  std::string text;                  ///< one line
};

/// Reads a value from its text in a config or on the command line, the same under any locale: a boolean is true, false,
/// on, off, yes or no; an integer is decimal; a real is decimal with a point, or decimal with exponent.
/// Throws ConfigError with a message that begins with the expectation ("expected an integer in [1, 16], got ...").
GESTALT_EXPORT ParameterValue parse_parameter(const Parameter& declaration, std::string_view text);

/// Text from which parse_parameter() gives the same value.
GESTALT_EXPORT std::string to_string(const ParameterValue& value);

/// "boolean", "integer", "real" or "choice".
GESTALT_EXPORT std::string to_string(Parameter::Type type);

/// "[1, 16]", "a | b", or "" when nothing limits the value.
GESTALT_EXPORT std::string range_text(const Parameter& declaration);

/// The values with defaults filled in for absent ones. Throws ConfigError for an unknown name, a value of the wrong
/// type, or one out of range.
GESTALT_EXPORT ParameterValues complete(const std::vector<Parameter>& declarations, const ParameterValues& given);

/// The declared parameters of a component whose settings are the members of a plain struct. Each is declared once, with
/// its default taken from the struct:
///
///     static const Parameters<Params>& parameters() {
///       static const auto p = Parameters<Params>().integer("bins", &Params::bins, 1, 16, "", "bins of a channel");
///       return p;
///     }
template <class Params>
class Parameters {
 public:
  Parameters& boolean(std::string name, bool Params::*member, std::string text) {
    return add({std::move(name), Parameter::Type::boolean, Params{}.*member, 0, 1, {}, "", std::move(text)},
               [member](Params& p, const ParameterValue& v) { p.*member = std::get<bool>(v); });
  }
  Parameters& integer(std::string name, int Params::*member, int low, int high, std::string unit, std::string text) {
    return add({std::move(name),
                Parameter::Type::integer,
                std::int64_t{Params{}.*member},
                double(low),
                double(high),
                {},
                std::move(unit),
                std::move(text)},
               [member](Params& p, const ParameterValue& v) { p.*member = int(std::get<std::int64_t>(v)); });
  }
  Parameters& real(std::string name, double Params::*member, double low, double high, std::string unit,
                   std::string text) {
    return add(
        {std::move(name), Parameter::Type::real, Params{}.*member, low, high, {}, std::move(unit), std::move(text)},
        [member](Params& p, const ParameterValue& v) { p.*member = std::get<double>(v); });
  }
  Parameters& choice(std::string name, std::string Params::*member, std::vector<std::string> words, std::string text) {
    return add(
        {std::move(name), Parameter::Type::choice, Params{}.*member, 0, 0, std::move(words), "", std::move(text)},
        [member](Params& p, const ParameterValue& v) { p.*member = std::get<std::string>(v); });
  }

  const std::vector<Parameter>& declarations() const { return declarations_; }

  /// Throws ConfigError as complete() does.
  Params read(const ParameterValues& given) const {
    const ParameterValues values = complete(declarations_, given);
    Params params;
    for (std::size_t i = 0; i < declarations_.size(); ++i) assign_[i](params, values.at(declarations_[i].name));
    return params;
  }

 private:
  Parameters& add(Parameter declaration, std::function<void(Params&, const ParameterValue&)> assign) {
    declarations_.push_back(std::move(declaration));
    assign_.push_back(std::move(assign));
    return *this;
  }

  std::vector<Parameter> declarations_;
  std::vector<std::function<void(Params&, const ParameterValue&)>> assign_;
};

}  // namespace gestalt
