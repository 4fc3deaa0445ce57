// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "gestalt/core/base/error.h"
#include "gestalt/evaluation/experiment/ablation.h"
#include "gestalt/tests/environment/temporary_folder.h"

namespace gestalt::test {
namespace {

using Texts = std::vector<std::string>;

void expect_error(const auto& call, const Texts& words) {
  try {
    call();
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    for (const std::string& word : words)
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << word << " not in " << error.what();
  }
}

TEST(Grid, CombinesAllValues) {
  const std::vector<OverrideSet> sets = grid({"a.b=1,2", "c=x,y,z"});
  ASSERT_EQ(sets.size(), 6u);
  EXPECT_EQ(sets[0].name, "a.b=1 c=x");
  EXPECT_EQ(sets[4].overrides, (Texts{"a.b=2", "c=y"}));
  EXPECT_TRUE(grid({}).empty());
}

TEST(Grid, RefusesWhatIsNoAxis) {
  for (const char* axis : {"a.b", "=1,2", "a.b=", "a.b=1,,2", "a.b=1,"})
    expect_error([&] { grid({axis}); }, {std::string("--grid ") + axis});
}

TEST(Grid, RefusesMoreVariantsThanAnyoneWaitsFor) {
  const Texts axes(8, "a=1,2,3,4,5,6,7,8,9");
  expect_error([&] { grid(axes); }, {"--grid a=1,2,3", "more than 10000 variants"});
}

TEST(OverrideSets, AreReadInOrder) {
  const TemporaryFolder folder;
  const auto sets =
      read_override_sets(folder.write("v.yaml", "small: [structural.minimum_size=20, a=b]\nno gabor: r.gabor=off\n"));
  ASSERT_EQ(sets.size(), 2u);
  EXPECT_EQ(sets[0].name, "small");
  EXPECT_EQ(sets[0].overrides, (Texts{"structural.minimum_size=20", "a=b"}));
  EXPECT_EQ(sets[1].name, "no gabor");
  EXPECT_EQ(sets[1].overrides, (Texts{"r.gabor=off"}));
}

TEST(OverrideSets, NameThePlaceOfAnError) {
  const TemporaryFolder folder;
  const auto refuse = [&](const std::string& text, const Texts& words) {
    expect_error([&] { read_override_sets(folder.write("v.yaml", text)); }, words);
  };
  refuse("# none\n", {"v.yaml:1:1", "no variants"});
  refuse("", {"v.yaml: is empty"});
  refuse("[a=b]\n", {"no variants"});
  refuse("one: a=b\n---\ntwo: a=c\n", {"v.yaml:3:1", "second YAML document"});
  refuse("a: b=c\na: b=d\n", {"v.yaml:2:1", "'a'", "appears twice"});
  refuse("a: b=c\nd: []\n", {"v.yaml:2:1", "'d'"});
  refuse("a:\n  - {b: c}\n", {"v.yaml:2:5", "path=value"});
  refuse("a: [b\n", {"v.yaml:2:1", "not valid YAML"});
  expect_error([&] { read_override_sets(folder.path() / "nothing.yaml"); }, {"nothing.yaml", "does not exist"});
}

}  // namespace
}  // namespace gestalt::test
