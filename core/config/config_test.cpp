// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/config/config.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <clocale>
#include <cstdio>
#include <fstream>
#include <locale>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

namespace gestalt {
namespace {

namespace fs = std::filesystem;

using Overrides = std::vector<std::string>;

// Plugins of the tests: clusterers steps and grid, fitters flat and round, relations colour, texture and border,
// classifiers line and tree, solver cut; each with smooth = true, bins = 4 in [1, 16], sigma = 1.5 in [0, 10] m and
// norm = l2 of l1 | l2.
const char* const base_text = R"(schema_version: 1
signal:
  clusterer: steps
primitive:
  fitters: [flat]
structural:
  relations:
    - colour
    - {plugin: texture, params: {bins: 8}}
  classifier: {plugin: line, params: {sigma: 3}}
decision:
  solver: cut
)";

class ConfigTest : public testing::Test {
 protected:
  ConfigTest() : folder_(fs::path(testing::TempDir()) / (std::string("gestalt_config_") + test_name())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    write("base.yaml", base_text);
  }
  ~ConfigTest() override { fs::remove_all(folder_); }

  static std::string test_name() { return testing::UnitTest::GetInstance()->current_test_info()->name(); }

  fs::path write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  /// A config that extends base.yaml.
  fs::path extend(const std::string& text) const {
    return write("extended.yaml", "schema_version: 1\nextends: base.yaml\n" + text);
  }

  Config resolve(const fs::path& file, const Overrides& overrides = {}) const {
    return ConfigTree(file, overrides).resolve(registry_);
  }

  /// The lines of the error that a config gives, the test's folder left out; empty when it gives none.
  std::vector<std::string> errors(const fs::path& file, const Overrides& overrides = {}) const {
    try {
      resolve(file, overrides);
    } catch (const ConfigError& error) {
      std::vector<std::string> lines;
      std::istringstream stream(error.what());
      for (std::string line; std::getline(stream, line);) lines.push_back(without_folder(line));
      return lines;
    }
    return {};
  }

  std::vector<std::string> errors_of_text(const std::string& text) const { return errors(write("test.yaml", text)); }

  std::string without_folder(std::string line) const {
    const std::string folder = folder_.string() + "/";
    for (std::size_t at = line.find(folder); at != std::string::npos; at = line.find(folder, at))
      line.erase(at, folder.size());
    return line;
  }

  const fs::path folder_;
  const fs::path base_ = folder_ / "base.yaml";
  const Registry registry_{{GESTALT_TEST_PLUGINS}};
};

std::vector<std::string> names(const std::vector<ComponentConfig>& components) {
  std::vector<std::string> names;
  for (const ComponentConfig& component : components) names.push_back(component.name);
  return names;
}

using Names = std::vector<std::string>;
using Lines = std::vector<std::string>;

double real(const ComponentConfig& component, const char* name) { return std::get<double>(component.params.at(name)); }
std::int64_t integer(const ComponentConfig& component, const char* name) {
  return std::get<std::int64_t>(component.params.at(name));
}

void expect_equal(const ComponentConfig& a, const ComponentConfig& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.plugin, b.plugin);
  EXPECT_EQ(a.params, b.params);
  EXPECT_EQ(a.values, b.values);
}

void expect_equal(const std::vector<ComponentConfig>& a, const std::vector<ComponentConfig>& b) {
  ASSERT_EQ(names(a), names(b));
  for (std::size_t i = 0; i < a.size(); ++i) expect_equal(a[i], b[i]);
}

void expect_equal(const LevelConfig& a, const LevelConfig& b) {
  expect_equal(a.relations, b.relations);
  expect_equal(a.classifier, b.classifier);
  EXPECT_EQ(a.minimum_size, b.minimum_size);
  EXPECT_EQ(a.negatives, b.negatives);
}

void expect_equal(const Config& a, const Config& b) {
  expect_equal(a.clusterer, b.clusterer);
  expect_equal(a.fitters, b.fitters);
  EXPECT_EQ(a.surface_modelling, b.surface_modelling);
  EXPECT_EQ(a.with_assembly, b.with_assembly);
  EXPECT_EQ(a.model, b.model);
  EXPECT_EQ(a.sensor, b.sensor);
  expect_equal(a.structural, b.structural);
  ASSERT_EQ(a.assembly.has_value(), b.assembly.has_value());
  if (a.assembly) expect_equal(*a.assembly, *b.assembly);
  expect_equal(a.solver, b.solver);
}

// Values and defaults

TEST_F(ConfigTest, ReadsComponentsAndFillsInDefaults) {
  const Config config = resolve(base_);
  EXPECT_EQ(config.clusterer.plugin, "steps");
  EXPECT_EQ(integer(config.clusterer, "bins"), 4);
  EXPECT_EQ(names(config.fitters), Names{"flat"});
  EXPECT_EQ(names(config.structural.relations), (Names{"colour", "texture"}));
  EXPECT_EQ(integer(config.structural.relations[1], "bins"), 8);
  EXPECT_EQ(std::get<bool>(config.structural.relations[1].params.at("smooth")), true);
  EXPECT_EQ(real(config.structural.classifier, "sigma"), 3.0);
  EXPECT_EQ(config.solver.plugin, "cut");
  EXPECT_EQ(config.structural.minimum_size, 30);
  EXPECT_TRUE(config.model.empty());
  EXPECT_EQ(std::get<double>(config.surface_modelling.at("kappa_2")), 1.0);
}

TEST_F(ConfigTest, AListMayBeWrittenAsAMapping) {
  const Config config = resolve(extend(R"(structural:
  relations:
    border: on
    coarse: {plugin: colour, params: {bins: 2}}
    fine: colour
)"));
  EXPECT_EQ(names(config.structural.relations), (Names{"colour", "texture", "border", "coarse", "fine"}));
  EXPECT_EQ(config.structural.relations[3].plugin, "colour");
  EXPECT_EQ(integer(config.structural.relations[3], "bins"), 2);
  EXPECT_EQ(config.structural.relations[4].plugin, "colour");
  EXPECT_EQ(integer(config.structural.relations[4], "bins"), 4);
}

TEST_F(ConfigTest, ALeadingZeroIsNoOctalNumber) {
  EXPECT_EQ(resolve(extend("structural: {minimum_size: 010}")).structural.minimum_size, 10);
}

TEST_F(ConfigTest, AnAliasRepeatsAValue) {
  const Config config = resolve(extend(R"(signal: {clusterer: {plugin: steps, params: &p {bins: 7}}}
decision: {solver: {plugin: cut, params: *p}}
)"));
  EXPECT_EQ(integer(config.clusterer, "bins"), 7);
  EXPECT_EQ(integer(config.solver, "bins"), 7);
}

// Merging

TEST_F(ConfigTest, ListsMergeByName) {
  const Config config = resolve(extend(R"(structural:
  relations:
    - border
    - {plugin: texture, params: {sigma: 2}}
)"));
  EXPECT_EQ(names(config.structural.relations), (Names{"colour", "texture", "border"}));
  EXPECT_EQ(integer(config.structural.relations[1], "bins"), 8);
  EXPECT_EQ(real(config.structural.relations[1], "sigma"), 2.0);
}

TEST_F(ConfigTest, OffTakesAComponentOutAndOnBringsItBackInItsPlace) {
  const fs::path file = extend("structural: {relations: {colour: off}}");
  EXPECT_EQ(names(resolve(file).structural.relations), Names{"texture"});
  EXPECT_EQ(names(resolve(file, {"structural.relations.colour=on"}).structural.relations),
            (Names{"colour", "texture"}));
}

TEST_F(ConfigTest, ANewPluginDropsTheParamsOfTheOldOne) {
  EXPECT_EQ(real(resolve(extend("structural: {classifier: tree}")).structural.classifier, "sigma"), 1.5);
  EXPECT_EQ(real(resolve(extend("structural: {classifier: line}")).structural.classifier, "sigma"), 3.0);
  const Config config = resolve(extend("structural: {classifier: {params: {bins: 2}, plugin: tree}}"));
  EXPECT_EQ(real(config.structural.classifier, "sigma"), 1.5);
  EXPECT_EQ(integer(config.structural.classifier, "bins"), 2);
}

TEST_F(ConfigTest, ALevelMayHaveAPartOfARelationsValues) {
  const auto values = [this](const std::string& colour, const Overrides& overrides = {}) {
    return resolve(extend("structural: {relations: {colour: " + colour + "}}"), overrides)
        .structural.relations[0]
        .values;
  };
  EXPECT_EQ(values("{values: [r_two]}"), Names{"r_two"});
  EXPECT_EQ(values("{values: [r_three, r_one, r_three]}"), (Names{"r_one", "r_three"})) << "its own order";
  EXPECT_EQ(values("{values: [r_three, r_one, r_two]}"), Names{}) << "all are not a part";
  EXPECT_EQ(values("on"), Names{});
  EXPECT_EQ(values("on", {"structural.relations.colour.values=[r_one]"}), Names{"r_one"});
  EXPECT_EQ(values("{values: [r_two]}", {"structural.relations.colour.params.bins=2"}), Names{"r_two"});
  EXPECT_EQ(values("{values: [r_two]}", {"structural.relations.colour.values=all"}), Names{});
  EXPECT_EQ(values("{values: [r_two]}", {"structural.relations.colour.plugin=border"}), Names{});
  EXPECT_EQ(resolve(extend("structural: {relations: [{name: a, plugin: border, values: [r_one]}]}"))
                .structural.relations.back()
                .values,
            Names{"r_one"});
}

TEST_F(ConfigTest, AChainMergesFromItsEnd) {
  write("middle.yaml", "schema_version: 1\nextends: base.yaml\nstructural: {minimum_size: 40, classifier: tree}\n");
  const fs::path file =
      write("sub/top.yaml", "schema_version: 1\nextends: ../middle.yaml\nstructural: {minimum_size: 50}\n");
  EXPECT_EQ(resolve(file).structural.minimum_size, 50);
  EXPECT_EQ(resolve(file).structural.classifier.plugin, "tree");
}

TEST_F(ConfigTest, PluginDirectoriesAreRelativeToTheirFile) {
  write("base.yaml", std::string(base_text) + "plugin_directories: [plugins]\n");
  const fs::path file =
      write("sub/top.yaml", "schema_version: 1\nextends: ../base.yaml\nplugin_directories: [mine, /yours]\n");
  const std::vector<fs::path> expected{folder_ / "sub/mine", "/yours", folder_ / "plugins"};
  EXPECT_EQ(ConfigTree(file, {}).plugin_directories(), expected);
}

TEST_F(ConfigTest, AModelIsLookedUpBesideTheFileThatNamesIt) {
  write("base.yaml", std::string(base_text) + "  # the model\n");
  write("sub/middle.yaml", "schema_version: 1\nextends: ../base.yaml\nmodel: mine.json\n");
  const fs::path file = write("top.yaml", "schema_version: 1\nextends: sub/middle.yaml\n");
  EXPECT_EQ(resolve(file).model, folder_ / "sub/mine.json");
  EXPECT_TRUE(resolve(file, {"model=none"}).model.empty());
}

// Overrides

TEST_F(ConfigTest, OverridesSetValuesInOrder) {
  const Config config =
      resolve(base_, {"structural.relations.texture=off", "structural.relations.border=on",
                      "structural.relations.border.params.sigma=2.5", "structural.minimum_size=50",
                      "structural.minimum_size=60", "signal.clusterer=grid", "signal.clusterer.params.bins=3",
                      "structural.classifier={plugin: tree, params: {norm: l1}}", "primitive.fitters=[round]",
                      "primitive.model_selection.sigma=2.75"});
  EXPECT_EQ(names(config.structural.relations), (Names{"colour", "border"}));
  EXPECT_EQ(real(config.structural.relations[1], "sigma"), 2.5);
  EXPECT_EQ(config.structural.minimum_size, 60);
  EXPECT_EQ(config.clusterer.plugin, "grid");
  EXPECT_EQ(integer(config.clusterer, "bins"), 3);
  EXPECT_EQ(config.structural.classifier.plugin, "tree");
  EXPECT_EQ(std::get<std::string>(config.structural.classifier.params.at("norm")), "l1");
  EXPECT_EQ(names(config.fitters), (Names{"flat", "round"}));
  EXPECT_EQ(std::get<double>(config.surface_modelling.at("sigma")), 2.75);
}

TEST_F(ConfigTest, WrongOverridesAreNamedWithTheClosestWord) {
  const auto error = [this](const std::string& override) { return errors(base_, {override}); };
  EXPECT_EQ(error("foo"), Lines{"--set foo: expected path=value, as in structural.minimum_size=50"});
  EXPECT_EQ(error("a..b=x"), Lines{"--set a..b=x: expected path=value, as in structural.minimum_size=50"});
  EXPECT_EQ(error("extends=x.yaml"),
            Lines{"--set extends=x.yaml: extends: can be set only in a file, not on the command line"});
  EXPECT_EQ(error("structual.minimum_size=3"),
            Lines{"--set structual.minimum_size=3: structual: unknown key; did you mean 'structural'?"});
  EXPECT_EQ(error("structural.relations.textur=off"),
            Lines{"--set structural.relations.textur=off: structural.relations.textur: the list has no component of "
                  "this name; did you mean 'texture'?"});
  EXPECT_EQ(error("structural.relations.colour.params.bin=1"),
            Lines{"--set structural.relations.colour.params.bin=1: structural.relations.colour.params.bin: unknown "
                  "parameter; did you mean 'bins'?"});
  EXPECT_EQ(error("structural.relations.colour.params.bins=17"),
            Lines{"--set structural.relations.colour.params.bins=17: structural.relations.colour.params.bins: expected "
                  "an integer in [1, 16], got '17'"});
  EXPECT_EQ(error("signal.clusterer=off").size(), 1u);
  EXPECT_EQ(error("structural.relations=[").size(), 1u);
}

TEST_F(ConfigTest, TakingOutTheLastComponentIsAnError) {
  EXPECT_EQ(
      errors(base_, {"primitive.fitters.flat=off"}),
      Lines{"--set primitive.fitters.flat=off: primitive.fitters: the list is empty; it needs at least one fitter "
            "(known: flat, round)"});
}

// Errors of files

TEST_F(ConfigTest, AllErrorsAreToldTogetherWithTheirPlaces) {
  const Lines found = errors_of_text(R"(schema_version: 2
signal:
  clustrer: steps
  clusterer: {plugin: stepps}
primitive:
  fitters: []
structural:
  relations: {colour: {params: {
    bin: 3,
    sigma: 11}}, texture: {params: {smooth: maybe}}}
  minimum_size: "30"
  minimum_size: 40
  classifier: {params: {}}
decision: [cut]
)");
  const Lines expected{
      "test.yaml:1:1: decision.solver: names no plugin; expected the name of a solver (known: cut)",
      "test.yaml:1:17: schema_version: expected 1, the version this program reads, got '2'",
      "test.yaml:3:3: signal.clustrer: unknown key; did you mean 'clusterer'?",
      "test.yaml:4:23: signal.clusterer: there is no clusterer 'stepps'; did you mean 'steps'? (known: grid, steps)",
      "test.yaml:6:12: primitive.fitters: the list is empty; it needs at least one fitter (known: flat, round)",
      "test.yaml:9:5: structural.relations.colour.params.bin: unknown parameter; did you mean 'bins'?",
      "test.yaml:10:12: structural.relations.colour.params.sigma: expected a number in [0, 10] m, got '11'",
      "test.yaml:10:45: structural.relations.texture.params.smooth: expected true or false, got 'maybe'",
      "test.yaml:11:17: structural.minimum_size: expected the value without quotes, got \"30\"",
      "test.yaml:12:3: structural.minimum_size: duplicate key, first at line 11",
      "test.yaml:13:15: structural.classifier: names no plugin; expected the name of a classifier (known: line, tree)",
      "test.yaml:14:11: decision: expected keys and values, got a list",
      "  searched:",
      "    " GESTALT_TEST_PLUGINS};
  EXPECT_EQ(found, expected);
}

TEST_F(ConfigTest, EveryFileOfAChainNeedsItsVersion) {
  write("base.yaml", std::string(base_text).substr(std::string("schema_version: 1\n").size()));
  EXPECT_EQ(errors(write("top.yaml", "extends: base.yaml\n")),
            (Lines{"base.yaml:1:1: schema_version: is missing; this program reads 'schema_version: 1'",
                   "top.yaml:1:1: schema_version: is missing; this program reads 'schema_version: 1'"}));
  EXPECT_EQ(errors(write("quoted.yaml", std::string(base_text).replace(0, 17, "schema_version: '1'"))),
            Lines{"quoted.yaml:1:17: schema_version: expected 1, the version this program reads, got '1' in quotes"});
}

TEST_F(ConfigTest, WhatYamlAllowsAndAConfigDoesNotIsAnError) {
  const auto error = [this](const std::string& text) { return errors(extend(text)); };
  EXPECT_EQ(error("<<: {signal: {clusterer: grid}}"),
            Lines{"extended.yaml:3:1: <<: YAML's merge keys are not supported; include another file with 'extends:'"});
  EXPECT_EQ(error("structural: {minimum_size: !!int 40}"),
            Lines{"extended.yaml:3:28: structural.minimum_size: tags like 'tag:yaml.org,2002:int' are not supported"});
  EXPECT_EQ(error("[a, b]: c").at(0), "extended.yaml:3:1: a key must be plain text, got a list");
  EXPECT_EQ(error("---\na: 1"), Lines{"extended.yaml:3:1: second YAML document; a config file holds one document"});
  EXPECT_EQ(
      error("structural: {minimum_size: 0x20}"),
      Lines{"extended.yaml:3:28: structural.minimum_size: expected an integer in [1, 1000000] pixels, got '0x20'"});
  EXPECT_EQ(error("structural:\n  minimum_size:\n\n\ndecision: {}"),
            Lines{"extended.yaml:4:3: structural.minimum_size: expected an integer in [1, 1000000] pixels, got ''"});
}

TEST_F(ConfigTest, WrongListsOfComponentsAreErrors) {
  const auto error = [this](const std::string& relations) {
    return errors(extend("structural: {relations: " + relations + "}"));
  };
  EXPECT_EQ(error("[border, border]"), Lines{"extended.yaml:3:34: structural.relations.border: duplicate name in the "
                                             "list; give one of the two another 'name:'"});
  EXPECT_EQ(error("[{params: {bins: 1}}]"),
            Lines{"extended.yaml:3:26: structural.relations[0]: expected a component with a 'plugin:', got none"});
  EXPECT_EQ(error("border"),
            Lines{"extended.yaml:3:25: structural.relations: expected a list of components, got 'border'"});
  EXPECT_EQ(error("[{name: a.b, plugin: border}]"),
            Lines{"extended.yaml:3:33: structural.relations[0]: a component's name is of letters, digits, '_' and '-', "
                  "got 'a.b'"});
  EXPECT_EQ(error("{border: {plugin: border, parms: {}}}"),
            Lines{"extended.yaml:3:51: structural.relations.border.parms: unknown key; did you mean 'params'?"});
  EXPECT_EQ(error("{border: {params: {bins: [1]}}}"),
            Lines{"extended.yaml:3:50: structural.relations.border.params.bins: expected one value, got a list"});
  EXPECT_EQ(
      error("{border: {values: [r_one, r_tow], params: {bins: 0}}}"),
      (Lines{"extended.yaml:3:51: structural.relations.border.values: 'border' has no value 'r_tow'; did you mean "
             "'r_two'?",
             "extended.yaml:3:74: structural.relations.border.params.bins: expected an integer in [1, 16], got "
             "'0'"}));
  EXPECT_EQ(
      error("{border: {values: r_one}}"),
      Lines{"extended.yaml:3:43: structural.relations.border.values: expected a list of the relation's values, as "
            "in [r_cu3], or all, got 'r_one'"});
  EXPECT_EQ(
      error("{border: {values: []}}"),
      Lines{"extended.yaml:3:43: structural.relations.border.values: expected a list of the relation's values, as "
            "in [r_cu3], or all"});
  EXPECT_EQ(errors(extend("primitive: {fitters: {flat: {values: [r_one]}}}")),
            Lines{"extended.yaml:3:30: primitive.fitters.flat.values: unknown key"});
  EXPECT_EQ(error("[off]"),
            Lines{"extended.yaml:3:26: structural.relations[0]: expected a component's name, got 'off'"});
  EXPECT_EQ(error("[{name: colour, plugin: off}]"),
            Lines{"extended.yaml:3:49: structural.relations.colour.plugin: expected a plugin's name, got 'off'; on and "
                  "off are for a component of a list, as in 'relations: {name: off}'"});
}

TEST_F(ConfigTest, AValueOfAnotherKindIsAnError) {
  const auto error = [this](const std::string& text) { return errors(extend(text)); };
  EXPECT_EQ(error("structural: {relations: {border: {params: [1]}}}"),
            Lines{"extended.yaml:3:43: structural.relations.border.params: expected names and values, got a list"});
  EXPECT_EQ(error("plugin_directories: plugins"),
            Lines{"extended.yaml:3:21: plugin_directories: expected a list of directories, got 'plugins'"});
  EXPECT_EQ(error("plugin_directories: [{plugins: here}]"),
            Lines{"extended.yaml:3:22: plugin_directories: expected a directory, got a mapping"});
  EXPECT_EQ(errors(base_, {"structural.relations="}),
            Lines{"--set structural.relations=: structural.relations: expected a list of components, got nothing"});
}

TEST_F(ConfigTest, AFileThatCannotBeReadIsAnErrorAtOnce) {
  EXPECT_EQ(errors(folder_ / "none.yaml"), Lines{"cannot read config 'none.yaml': No such file or directory"});
  EXPECT_EQ(errors(write("top.yaml", "schema_version: 1\nextends: none.yaml\n")),
            Lines{"top.yaml:2:10: extends: cannot read config 'none.yaml': No such file or directory"});
  EXPECT_NE(errors(folder_).at(0).find("it is a directory"), std::string::npos);
  ASSERT_EQ(::mkfifo((folder_ / "pipe.yaml").c_str(), 0600), 0);  // opened, it would wait for a writer
  EXPECT_EQ(errors(folder_ / "pipe.yaml"),
            Lines{"cannot read config 'pipe.yaml': it is a pipe or device; copy it to a regular file"});
  EXPECT_NE(errors(write("above.yaml", "schema_version: 1\nextends: pipe.yaml\n")).at(0).find("it is a pipe"),
            std::string::npos);
  EXPECT_NE(errors("/dev/zero").at(0).find("it is a pipe or device"), std::string::npos);
  EXPECT_NE(errors_of_text("a: [1\nb: 2\n").at(0).find("test.yaml:2:2: a[1]: not valid YAML: "), std::string::npos);
  EXPECT_EQ(errors_of_text("").at(0), "test.yaml:1:1: the file is empty; a config begins with 'schema_version: 1'");
  EXPECT_EQ(errors_of_text("gabor").at(0), "test.yaml:1:1: expected keys and values, got 'gabor'");
}

TEST_F(ConfigTest, AChainThatComesBackToItselfIsAnError) {
  write("a.yaml", "schema_version: 1\nextends: b.yaml\n");
  const fs::path b = write("b.yaml", "schema_version: 1\nextends: ./a.yaml\n");
  EXPECT_EQ(errors(b), Lines{"a.yaml:2:10: extends: the config extends itself: b.yaml -> a.yaml -> b.yaml"});
  const fs::path self = write("self.yaml", "schema_version: 1\nextends: self.yaml\n");
  EXPECT_EQ(errors(self), Lines{"self.yaml:2:10: extends: the config extends itself: self.yaml -> self.yaml"});
}

TEST_F(ConfigTest, AChainHasAtMost16Files) {
  for (int i = 1; i <= 16; ++i)
    write(std::to_string(i) + ".yaml", "schema_version: 1\nextends: " + std::to_string(i + 1) + ".yaml\n");
  write("16.yaml", base_text);
  EXPECT_EQ(errors(folder_ / "1.yaml"), Lines{});
  write("16.yaml", "schema_version: 1\nextends: base.yaml\n");
  const Lines found = errors(folder_ / "1.yaml");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].substr(0, 86),
            "16.yaml:2:10: extends: more than 16 configs extend each other: 1.yaml -> 2.yaml -> 3.y");
}

TEST_F(ConfigTest, HostileFilesAreRefused) {
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 30; ++i) {
    const std::string alias = "*a" + std::to_string(i - 1);
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + alias + ", " + alias + "]\n";
  }
  EXPECT_NE(errors_of_text(bomb).at(0).find("more than 10000 values"), std::string::npos);
  EXPECT_NE(errors_of_text("a: &a\n  b: *a\n").at(0).find("refers to a value that contains it"), std::string::npos);
  EXPECT_NE(errors_of_text("a: " + std::string(100000, '[')).at(0).find("nested deeper than 32"), std::string::npos);
  EXPECT_NE(errors_of_text(std::string((1 << 20) + 1, ' ')).at(0).find("larger than 1 MiB"), std::string::npos);
  EXPECT_EQ(errors_of_text("schema_version: 1\na: \x04\n").at(0),
            "test.yaml:2:4: control character; a config is a UTF-8 text file");
  const Lines escapes = errors(extend(R"("a\nb\e[31m\0c": 1)"));
  EXPECT_EQ(escapes, Lines{"extended.yaml:3:1: a?b?[31m?c: unknown key"});
}

TEST_F(ConfigTest, AMissingPluginTellsWhatWasRejected) {
  const fs::path broken = write("plugins/broken.so", "no library").parent_path();
  const Registry registry({GESTALT_TEST_PLUGINS, broken});
  try {
    ConfigTree(base_, {"structural.relations.gabor=on", "structural.relations.fourier=on"}).resolve(registry);
    FAIL() << "resolved without its plugins";
  } catch (const ConfigError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("there is no relation 'gabor' (known: border, colour, texture)\n"), std::string::npos) << text;
    EXPECT_NE(text.find("there is no relation 'fourier'"), std::string::npos) << text;
    const std::size_t searched = text.find("  searched:");
    EXPECT_NE(searched, std::string::npos) << text;
    EXPECT_EQ(text.find("  searched:", searched + 1), std::string::npos) << text;
    EXPECT_NE(text.find(broken.string() + "/broken.so: "), std::string::npos) << text;
  }
}

// Printing

TEST_F(ConfigTest, PrintReadsBackToTheSameConfig) {
  const fs::path file = extend(R"(model: "odd # \"name\".json"
structural:
  minimum_size: 12
  relations:
    colour: off
    "null": {plugin: border, params: {sigma: 0.1, smooth: off, norm: l1}, values: [r_one, r_three]}
plugin_directories: [a b]
)");
  const ConfigTree tree(file, {"structural.relations.texture.params.sigma=1e-7"});
  const ConfigTree printed(write("elsewhere/printed.yaml", tree.print(registry_)), {});
  expect_equal(printed.resolve(registry_), tree.resolve(registry_));
  EXPECT_EQ(printed.plugin_directories(), tree.plugin_directories());
  const ConfigTree from_json(write("elsewhere/printed.json", tree.to_json(registry_).at("values").dump(2)), {});
  expect_equal(from_json.resolve(registry_), tree.resolve(registry_));
  const ConfigTree from_text = ConfigTree::from_text("a result", tree.to_json(registry_).at("values").dump(), {});
  expect_equal(from_text.resolve(registry_), tree.resolve(registry_));
  EXPECT_EQ(from_text.to_json(registry_).at("provenance").at("structural.minimum_size"), "a result:1");
}

TEST_F(ConfigTest, ATextIsCheckedAsAFileIs) {
  const auto error_of = [&](const std::string& text, const Overrides& overrides = {}) -> std::string {
    try {
      ConfigTree::from_text("a result", text, overrides).resolve(registry_);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(error_of(base_text), "");
  EXPECT_NE(error_of(std::string(base_text) + "extends: base.yaml\n").find("a result:13:10: extends: "),
            std::string::npos);
  EXPECT_NE(error_of("{").find("a result:"), std::string::npos);
  EXPECT_NE(error_of("[]").find("a result:1:1: "), std::string::npos);
  EXPECT_NE(error_of(base_text, {"structural.minimum_size=-1"}).find("--set structural.minimum_size=-1"),
            std::string::npos);
}

TEST_F(ConfigTest, EveryValueTellsWhereItCameFrom) {
  const fs::path file = extend("structural: {classifier: {params: {bins: 2}}}");
  const ConfigTree tree(file, {"structural.relations.colour=off", "structural.relations.texture.params.norm=l1"});
  const auto provenance = tree.to_json(registry_).at("provenance");
  EXPECT_EQ(provenance.at("signal.clusterer.plugin"), "base.yaml:3");
  EXPECT_EQ(provenance.at("structural.classifier.plugin"), "base.yaml:10");
  EXPECT_EQ(provenance.at("structural.classifier.params.sigma"), "base.yaml:10");
  EXPECT_EQ(provenance.at("structural.classifier.params.bins"), "extended.yaml:3");
  EXPECT_EQ(provenance.at("structural.relations.texture.params.bins"), "base.yaml:9");
  EXPECT_EQ(provenance.at("structural.relations.texture.params.norm"), "--set");
  EXPECT_FALSE(provenance.contains("structural.relations.texture.values"));
  EXPECT_EQ(provenance.at("structural.relations.colour"), "--set");
  EXPECT_EQ(provenance.at("structural.minimum_size"), "default");

  const std::string text = tree.print(registry_);
  EXPECT_NE(text.find("    texture:\n      plugin: texture  # base.yaml:9\n"), std::string::npos) << text;
  EXPECT_NE(text.find("        norm: l1  # --set\n"), std::string::npos) << text;
  EXPECT_NE(text.find("    # colour: off  # --set\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  minimum_size: 30  # default\n"), std::string::npos) << text;
}

TEST_F(ConfigTest, FilesOfOneNameAreToldApart) {
  const fs::path file = write("sub/base.yaml", "schema_version: 1\nextends: ../base.yaml\nsignal: {clusterer: grid}\n");
  const auto provenance = ConfigTree(file, {}).to_json(registry_).at("provenance");
  EXPECT_EQ(provenance.at("signal.clusterer.plugin"), "base.yaml:3");
  EXPECT_EQ(provenance.at("decision.solver.plugin"), base_.string() + ":12");
}

// Locale

/// A locale of C++ that writes 1.234,5.
class CommaLocale {
 public:
  CommaLocale() : old_(std::locale::global(std::locale(std::locale::classic(), new Comma))) {}
  ~CommaLocale() { std::locale::global(old_); }

 private:
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  std::locale old_;
};

TEST_F(ConfigTest, ACommaLocaleOfCppChangesNothing) {
  const Overrides overrides{"structural.classifier.params.sigma=2.5", "structural.minimum_size=12345"};
  const std::string printed = ConfigTree(base_, overrides).print(registry_);
  const CommaLocale comma;
  const ConfigTree tree(base_, overrides);
  EXPECT_EQ(real(tree.resolve(registry_).structural.classifier, "sigma"), 2.5);
  EXPECT_EQ(tree.print(registry_), printed);
  EXPECT_EQ(errors(base_, {"structural.classifier.params.sigma=2,5"}).size(), 1u);
  EXPECT_EQ(errors(extend(std::string(1500, '\n') + "a: 1")), Lines{"extended.yaml:1503:1: a: unknown key"});
}

TEST_F(ConfigTest, ACommaLocaleOfCChangesNothing) {
  const std::string old = std::setlocale(LC_ALL, nullptr);
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8") && !std::setlocale(LC_ALL, "de_DE"))
    GTEST_SKIP() << "this machine has no locale de_DE";
  const ConfigTree tree(base_, {"structural.classifier.params.sigma=2.5"});
  const Config config = tree.resolve(registry_);
  const std::string printed = tree.print(registry_);
  std::setlocale(LC_ALL, old.c_str());
  EXPECT_EQ(real(config.structural.classifier, "sigma"), 2.5);
  EXPECT_EQ(printed, tree.print(registry_));
}

// Levels

const char* const assembly_text = R"(levels: structural+assembly
assembly:
  relations: [border, colour]
  classifier: tree
)";

TEST_F(ConfigTest, TheAssemblyLevelHasASectionOfItsOwn) {
  const Config config = resolve(extend(assembly_text));
  EXPECT_TRUE(config.with_assembly);
  ASSERT_TRUE(config.assembly);
  EXPECT_EQ(names(config.assembly->relations), (Names{"border", "colour"}));
  EXPECT_EQ(config.assembly->classifier.plugin, "tree");
  EXPECT_EQ(config.assembly->minimum_size, 300);
  EXPECT_EQ(names(config.structural.relations), (Names{"colour", "texture"}));
  EXPECT_EQ(names(resolve(folder_ / "extended.yaml", {"assembly.relations.colour=off"}).assembly->relations),
            Names{"border"});
}

TEST_F(ConfigTest, LevelsSwitchesTheAssemblyLevel) {
  EXPECT_FALSE(resolve(base_).with_assembly);
  EXPECT_FALSE(resolve(base_).assembly);
  const Config off = resolve(extend(assembly_text), {"levels=structural"});
  EXPECT_FALSE(off.with_assembly);
  EXPECT_TRUE(off.assembly) << "kept in case it is switched on again";
  EXPECT_EQ(errors(base_, {"levels=structural+assembly"}),
            (Lines{"base.yaml:1:1: assembly.relations: the list is empty; it needs at least one relation (known: "
                   "border, colour, texture)",
                   "base.yaml:1:1: assembly.classifier: names no plugin; expected the name of a classifier (known: "
                   "line, tree)"}));
  EXPECT_EQ(errors(base_, {"levels=assembly"}).size(), 1u);
}

TEST_F(ConfigTest, EachLevelHasAHash) {
  const Config config = resolve(extend(assembly_text));
  const Config other = resolve(folder_ / "extended.yaml", {"assembly.minimum_size=50"});
  EXPECT_EQ(config_hash(config, Level::structural), config_hash(other, Level::structural));
  EXPECT_NE(config_hash(config, Level::assembly), config_hash(other, Level::assembly));
  EXPECT_THROW(config_hash(resolve(base_), Level::assembly), ConfigError);
}

// Hash

TEST_F(ConfigTest, TheHashChangesWithWhatChangesRelationValues) {
  const auto hash = [this](const Overrides& overrides) {
    return config_hash(resolve(base_, overrides), Level::structural);
  };
  const std::string base = hash({});
  EXPECT_EQ(base.size(), 16u);
  EXPECT_EQ(base.find_first_not_of("0123456789abcdef"), std::string::npos);
  for (const char* other : {"signal.clusterer=grid", "signal.clusterer.params.bins=5", "primitive.fitters.round=on",
                            "primitive.fitters.flat.params.bins=5", "primitive.model_selection.sigma=2.75",
                            "structural.relations.border=on", "structural.relations.colour=off",
                            "structural.relations.colour.params.bins=5", "structural.minimum_size=31",
                            "structural.relations.colour.values=[r_one]"})
    EXPECT_NE(hash({other}), base) << other;
  for (const char* same :
       {"structural.classifier=tree", "model=other.json", "decision.solver.params.bins=5", "sensor.noise=realsense",

        "structural.relations.colour.params.bins=4"})
    EXPECT_EQ(hash({same}), base) << same;

  Config swapped = resolve(base_);
  std::swap(swapped.structural.relations[0], swapped.structural.relations[1]);
  EXPECT_NE(config_hash(swapped, Level::structural), base);
}

/// FNV-1a of the documented text, so that a model of today is recognised tomorrow.
TEST(ConfigHash, IsTheFnv1aOfTheCanonicalText) {
  Config config;
  config.clusterer = {"c", "c", {{"x", 0.5}}};
  config.fitters = {{"f", "f", {}}};
  config.structural.minimum_size = 30;
  config.structural.relations = {{"any", "r", {{"on", true}, {"n", std::int64_t{2}}}}, {"part", "s", {}, {"s_1"}}};
  const std::string text =
      "clusterer c\n  x=0.5\nfitter f\nmodel_selection\nrelation r\n  n=2\n  on=true\nrelation s\n  only s_1\n"
      "minimum_size 30\n";
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : text) hash = (hash ^ std::uint64_t(c)) * 1099511628211u;
  char expected[17];
  std::snprintf(expected, sizeof expected, "%016llx", static_cast<unsigned long long>(hash));
  EXPECT_EQ(config_hash(config, Level::structural), expected);
}

TEST(DefaultConfig, IsFoundFromTheLibrary) {
  EXPECT_EQ(default_config().filename(), "default.yaml");
  const Registry none({});
  // Without plugins it is read as YAML, and every component of it is missed by name.
  try {
    ConfigTree(default_config(), {}).resolve(none);
    FAIL() << "resolved without plugins";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("structural.relations.gabor: there is no relation 'gabor'"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace gestalt
