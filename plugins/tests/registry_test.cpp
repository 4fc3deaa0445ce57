// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/registry.h"
#include "gestalt/core/plugin/manifest.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <numeric>
#include <optional>

#include "gestalt/core/base/error.h"

namespace gestalt {
namespace {

namespace fs = std::filesystem;

fs::path broken(const std::string& folder) { return fs::path(BROKEN_PLUGINS) / folder; }

/// The message of the error E that f throws, or "" with a failure.
template <class E, class F>
std::string message_of(F f) {
  try {
    f();
  } catch (const E& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

void expect_in(const std::string& part, const std::string& text) {
  EXPECT_NE(text.find(part), std::string::npos) << "no \"" << part << "\" in: " << text;
}

/// Loads a folder whose only library must be rejected; gives the reason.
std::string rejection(const std::string& folder) {
  const Registry registry({broken(folder)});
  EXPECT_TRUE(registry.components().empty());
  EXPECT_EQ(registry.rejected().size(), 1u);
  if (registry.rejected().empty()) return "";
  EXPECT_EQ(registry.rejected()[0].library.parent_path(), broken(folder));
  return registry.rejected()[0].reason;
}

TEST(Registry, TakesASoundPlugin) {
  const Registry registry({broken("sound")});
  EXPECT_TRUE(registry.rejected().empty());
  const ComponentInfo* info = registry.find("solver", "one_group");
  ASSERT_TRUE(info);
  EXPECT_EQ(info->version, "1.2.3");
  EXPECT_EQ(info->description, "Every node in one group");
  EXPECT_EQ(info->library, broken("sound") / "sound.so");
  EXPECT_EQ(registry.names("solver"), std::vector<std::string>{"one_group"});
  EXPECT_TRUE(registry.names("relation").empty());
  ASSERT_EQ(registry.parameters("solver", "one_group").size(), 1u);
  EXPECT_EQ(registry.parameters("solver", "one_group")[0].name, "group");
}

TEST(Registry, AProductOutlivesItsRegistry) {
  std::shared_ptr<const Solver> solver;
  {
    const Registry registry({broken("sound")});
    solver = registry.create<Solver>("one_group", {{"group", std::int64_t{4}}});
  }
  EXPECT_EQ(solver->solve({{1, 1}, {}}), (std::vector<int>{4, 4}));
}

TEST(Registry, WrongParametersAreConfigErrorsThatNameTheComponent) {
  const Registry registry({broken("sound")});
  const auto message = message_of<ConfigError>([&] {
    registry.create<Solver>("one_group", {{"grup", std::int64_t{1}}});
  });
  expect_in("solver 'one_group'", message);
  expect_in("did you mean 'group'?", message);
}

TEST(Registry, AKindIsNotMistakenForAnother) {
  const Registry registry({broken("sound")});
  EXPECT_EQ(registry.find("fitter", "one_group"), nullptr);
  EXPECT_THROW(registry.create<Fitter>("one_group", {}), PluginError);
}

/// Every node in a group of its own.
struct Apart final : Solver {
  std::vector<int> solve(const Graph& graph) const override {
    std::vector<int> groups(graph.sizes.size());
    std::iota(groups.begin(), groups.end(), 0);
    return groups;
  }
};

Factory<Solver> apart() {
  return {{}, [](const ParameterValues&) { return std::make_unique<Apart>(); }};
}

TEST(Registry, TakesAComponentOfTheProgram) {
  Registry registry({broken("sound")});
  registry.add<Solver>({"", "apart", "1.0.0", "Every node alone", "this program"}, apart());
  EXPECT_EQ(registry.names("solver"), (std::vector<std::string>{"apart", "one_group"}));
  EXPECT_TRUE(registry.parameters("solver", "apart").empty());
  EXPECT_EQ(registry.create<Solver>("apart", {})->solve({{1, 1}, {}}), (std::vector<int>{0, 1}));
}

TEST(Registry, TakesNoComponentOfAPluginsNameFromTheProgram) {
  Registry registry({broken("sound")});
  const auto message = message_of<PluginError>([&] {
    registry.add<Solver>({"", "one_group", "1.0.0", "", "this program"}, apart());
  });
  expect_in("two plugins offer the solver 'one_group'", message);
  expect_in("this program", message);
}

TEST(Registry, RejectsAnOldInterface) {
  const std::string reason = rejection("old_interface");
  expect_in("interface 0", reason);
  expect_in("this core has " + std::to_string(GESTALT_INTERFACE_VERSION), reason);
}

TEST(Registry, RejectsAnotherBuildAndTellsBoth) {
  const std::string reason = rejection("other_fingerprint");
  expect_in("[abi=1 eigen=2.0.0]", reason);
  expect_in("[" + build_fingerprint() + "]", reason);
}

TEST(Registry, RejectsAForeignManifest) { expect_in("not a Gestalt manifest", rejection("other_magic")); }

TEST(Registry, RejectsALibraryWithoutTheEntrySymbol) { expect_in("gestalt_plugin_manifest", rejection("no_entry")); }

TEST(Registry, RejectsAnUndefinedSymbolInTheLoadersWords) {
  expect_in("undefined symbol: gestalt_function_that_nobody_defines", rejection("undefined_symbol"));
}

TEST(Registry, RejectsWhatIsNoLibraryInTheLoadersWords) {
  const std::string reason = rejection("not_a_library");
  expect_in("not_a_library.so", reason);
  expect_in("file too short", reason);
}

TEST(Registry, RejectsAnUnknownKind) {
  const std::string reason = rejection("unknown_kind");
  expect_in("unknown kind 'relatoin'", reason);
  expect_in("'relation'", reason);
}

TEST(Registry, RejectsAnIncompleteManifest) { expect_in("incomplete", rejection("incomplete")); }

TEST(Registry, ListsFactoriesThatFailAndTakesTheRest) {
  const Registry registry({broken("factories")});
  EXPECT_EQ(registry.names("solver"), (std::vector<std::string>{"gives_null", "one_group", "throws", "throws_an_int"}));
  ASSERT_EQ(registry.rejected().size(), 3u);
  expect_in("'throws_at_load' failed: no licence for this solver", registry.rejected()[0].reason);
  expect_in("'throws_an_int_at_load' failed", registry.rejected()[1].reason);
  expect_in("'null_at_load' returned nothing", registry.rejected()[2].reason);
}

TEST(Registry, WhatAFactoryDoesWrongIsAPluginError) {
  const Registry registry({broken("factories")});
  const auto message = [&](const char* name) {
    return message_of<PluginError>([&] { registry.create<Solver>(name, {}); });
  };
  expect_in("solver 'throws' could not be created: the table of weights is missing", message("throws"));
  expect_in("solver 'throws_an_int' could not be created", message("throws_an_int"));
  expect_in("solver 'gives_null' could not be created: its factory returned nothing", message("gives_null"));
}

TEST(Registry, TwoPluginsOfOneNameAreAnErrorNamingBoth) {
  const auto message = message_of<PluginError>([] { Registry({broken("sound"), broken("duplicate")}); });
  expect_in("solver 'one_group'", message);
  expect_in((broken("sound") / "sound.so").string(), message);
  expect_in((broken("duplicate") / "sound.so").string(), message);
}

TEST(Registry, ADirectoryMayBeListedTwice) {
  const Registry registry({broken("sound"), broken("sound/../sound"), broken("sound")});
  EXPECT_EQ(registry.components().size(), 1u);
  EXPECT_TRUE(registry.rejected().empty());
}

TEST(Registry, AMissingPluginTellsWhatWasSearchedAndRejected) {
  const Registry registry({broken("sound"), broken("not_there"), broken("undefined_symbol")});
  const auto message = message_of<PluginError>([&] { registry.create<Solver>("one_gruop", {}); });
  expect_in("no solver 'one_gruop'", message);
  expect_in("did you mean 'one_group'?", message);
  for (const char* folder : {"sound", "not_there", "undefined_symbol"})
    expect_in("\n    " + broken(folder).string() + "\n", message);
  expect_in((broken("undefined_symbol") / "undefined_symbol.so").string() + ": ", message);
  expect_in("gestalt_function_that_nobody_defines", message);
  EXPECT_EQ(message_of<PluginError>([&] { registry.parameters("solver", "one_gruop"); }), message);
}

TEST(Registry, SearchesDirectoriesInTheirOrder) {
  const std::vector<fs::path> order{broken("factories"), broken("old_interface"), broken("no_entry")};
  const Registry registry(order);
  EXPECT_EQ(registry.searched(), order);
  ASSERT_EQ(registry.rejected().size(), 5u);
  EXPECT_EQ(registry.rejected()[3].library.parent_path(), broken("old_interface"));
  EXPECT_EQ(registry.rejected()[4].library.parent_path(), broken("no_entry"));
}

/// Sets GESTALT_PLUGIN_PATH for one test.
class PluginPath : public testing::Test {
 protected:
  void SetUp() override {
    if (const char* value = std::getenv(name_)) before_ = value;
  }
  void TearDown() override {
    if (before_)
      ::setenv(name_, before_->c_str(), 1);
    else
      ::unsetenv(name_);
  }

  const char* const name_ = "GESTALT_PLUGIN_PATH";
  std::optional<std::string> before_;
};

TEST_F(PluginPath, ConfigThenVariableThenTheInstallation) {
  ::setenv(name_, (broken("sound").string() + ":/elsewhere").c_str(), 1);
  const auto path = plugin_search_path({"/of/the/config"});
  ASSERT_EQ(path.size(), 4u);
  EXPECT_EQ(path[0], "/of/the/config");
  EXPECT_EQ(path[1], broken("sound"));
  EXPECT_EQ(path[2], "/elsewhere");
  EXPECT_EQ(path[3], (fs::path(BROKEN_PLUGINS) / "../../lib/gestalt/plugins").lexically_normal());
}

TEST_F(PluginPath, LeavesOutRelativeAndEmptyEntries) {
  ::setenv(name_, "relative:::./here:/absolute:.", 1);
  const auto path = plugin_search_path({});
  ASSERT_EQ(path.size(), 2u);
  EXPECT_EQ(path[0], "/absolute");
  ::setenv(name_, "", 1);
  EXPECT_EQ(plugin_search_path({}).size(), 1u);
}

TEST_F(PluginPath, LoadsFromTheVariable) {
  ::setenv(name_, broken("sound").c_str(), 1);
  EXPECT_TRUE(Registry(plugin_search_path({})).find("solver", "one_group"));
  ::unsetenv(name_);
  EXPECT_FALSE(Registry(plugin_search_path({})).find("solver", "one_group"));
}

}  // namespace
}  // namespace gestalt
