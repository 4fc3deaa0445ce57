// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// What holds for a component of any kind: its manifest and its parameters.

#include <cmath>
#include <regex>
#include <set>

#include "gestalt/core/base/error.h"
#include "subjects.h"

namespace gestalt::conformance {
namespace {

TEST(Plugins, AreThere) {
  std::string searched;
  for (const auto& directory : subjects().searched()) searched += "\n  " + directory.string();
  EXPECT_FALSE(subjects().components().empty()) << "no component in" << searched;
}

TEST(Plugins, AreAllTaken) {
  for (const RejectedLibrary& r : subjects().rejected()) ADD_FAILURE() << r.library << ": " << r.reason;
}

/// Makes a component and drops it; only what is thrown matters.
void make(const ComponentInfo& info, const ParameterValues& values) {
  if (info.kind == kind_name<Clusterer>) subjects().create<Clusterer>(info.name, values);
  if (info.kind == kind_name<Fitter>) subjects().create<Fitter>(info.name, values);
  if (info.kind == kind_name<Relation>) subjects().create<Relation>(info.name, values);
  if (info.kind == kind_name<Classifier>) subjects().create<Classifier>(info.name, values);
  if (info.kind == kind_name<Solver>) subjects().create<Solver>(info.name, values);
}

bool is_one_line(const std::string& text) { return !text.empty() && text.find('\n') == std::string::npos; }

class Component : public testing::TestWithParam<ComponentInfo> {
 protected:
  const std::vector<Parameter>& parameters() const { return subjects().parameters(GetParam().kind, GetParam().name); }

  /// The component must refuse the value and name the parameter.
  void expect_refused(const std::string& name, const ParameterValue& value) const {
    try {
      make(GetParam(), {{name, value}});
      ADD_FAILURE() << name << " = " << to_string(value) << " was accepted";
    } catch (const ConfigError& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  }

  /// The component must be made, or say that the value and the others' defaults exclude each other.
  void expect_accepted(const std::string& name, const ParameterValue& value) const {
    try {
      make(GetParam(), {{name, value}});
    } catch (const ConfigError& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    } catch (const Error& error) {
      ADD_FAILURE() << name << " = " << to_string(value) << ": " << error.what();
    }
  }
};

TEST_P(Component, HasASaneManifest) {
  EXPECT_TRUE(std::regex_match(GetParam().name, std::regex("[a-z][a-z0-9_]*"))) << GetParam().name;
  EXPECT_TRUE(std::regex_match(GetParam().version, std::regex("[0-9]+\\.[0-9]+\\.[0-9]+"))) << GetParam().version;
  EXPECT_TRUE(is_one_line(GetParam().description)) << GetParam().description;
}

TEST_P(Component, DeclaresItsParametersCompletely) {
  std::set<std::string> names;
  for (const Parameter& p : parameters()) {
    EXPECT_TRUE(std::regex_match(p.name, std::regex("[a-z][a-z0-9_]*"))) << p.name;
    EXPECT_TRUE(names.insert(p.name).second) << p.name << " is declared twice";
    EXPECT_TRUE(is_one_line(p.text)) << p.name;
    EXPECT_TRUE(p.type == Parameter::Type::choice ? p.choices.size() > 1 : p.minimum < p.maximum)
        << p.name << " leaves no choice";
    EXPECT_NO_THROW(EXPECT_EQ(parse_parameter(p, to_string(p.default_value)), p.default_value)) << p.name;
  }
}

TEST_P(Component, IsMadeWithDefaults) { EXPECT_NO_THROW(make(GetParam(), {})); }

TEST_P(Component, TakesEveryBound) {
  for (const Parameter& p : parameters()) switch (p.type) {
      case Parameter::Type::boolean:
        expect_accepted(p.name, true);
        expect_accepted(p.name, false);
        break;
      case Parameter::Type::integer:
        expect_accepted(p.name, std::int64_t(p.minimum));
        expect_accepted(p.name, std::int64_t(p.maximum));
        break;
      case Parameter::Type::real:
        if (std::isfinite(p.minimum)) expect_accepted(p.name, p.minimum);
        if (std::isfinite(p.maximum)) expect_accepted(p.name, p.maximum);
        break;
      case Parameter::Type::choice:
        for (const std::string& word : p.choices) expect_accepted(p.name, word);
        break;
    }
}

TEST_P(Component, RefusesEveryParameterOutOfRange) {
  for (const Parameter& p : parameters()) switch (p.type) {
      case Parameter::Type::boolean:
        expect_refused(p.name, std::int64_t{1});
        break;
      case Parameter::Type::integer:
        expect_refused(p.name, std::int64_t(p.minimum) - 1);
        expect_refused(p.name, std::int64_t(p.maximum) + 1);
        expect_refused(p.name, std::string("1"));
        break;
      case Parameter::Type::real:
        if (std::isfinite(p.minimum)) expect_refused(p.name, std::nextafter(p.minimum, -HUGE_VAL));
        if (std::isfinite(p.maximum)) expect_refused(p.name, std::nextafter(p.maximum, HUGE_VAL));
        expect_refused(p.name, std::nan(""));
        expect_refused(p.name, HUGE_VAL);
        break;
      case Parameter::Type::choice:
        expect_refused(p.name, std::string("no_such_choice"));
        break;
    }
}

TEST_P(Component, RefusesAnUnknownParameter) { expect_refused("no_such_parameter", true); }

GESTALT_CONFORMANCE(Component, "");

}  // namespace
}  // namespace gestalt::conformance
