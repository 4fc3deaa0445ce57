// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/score/scene_sets.h"

#include <gtest/gtest.h>

#include "gestalt/core/base/error.h"
#include "gestalt/tests/environment/temporary_folder.h"

namespace gestalt {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

class SceneSets : public testing::Test {
 protected:
  fs::path scene(const std::string& path) const { return folder_.path() / path; }

  const test::TemporaryFolder folder_;
};

TEST_F(SceneSets, AreNamedByTheFoldersThatTellThemApart) {
  EXPECT_EQ(scene_sets({scene("learn/a"), scene("learn/b/"), scene("test/c.pcd")}), (Names{"learn", "learn", "test"}));
  EXPECT_EQ(scene_sets({scene("osd/learn/a"), scene("ours/learn/b"), scene("ours/test/c")}),
            (Names{"osd/learn", "ours/learn", "ours/test"}));
  EXPECT_EQ(scene_sets({"/a", "/learn/b"}), (Names{"", "learn"}));
  EXPECT_EQ(scene_sets({"/learn/a", "/x/learn/b"}), (Names{"learn", "x/learn"}));
  EXPECT_TRUE(scene_sets({}).empty());
}

TEST_F(SceneSets, OneSetHasARowForEachCategory) {
  folder_.write("learn.csv", "scene,category\na,boxes\nb,bowls\n");
  EXPECT_EQ(scene_rows({scene("learn/a"), scene("learn/b"), scene("learn/c")}), (Names{"boxes", "bowls", ""}));
}

TEST_F(SceneSets, SeveralSetsKeepTheirCategoriesApart) {
  folder_.write("learn.csv", "scene,category\na,boxes\n");
  folder_.write("ours.csv", "scene,category\nb,boxes\n");
  EXPECT_EQ(scene_rows({scene("learn/a"), scene("ours/b"), scene("ours/c"), scene("theirs/d")}),
            (Names{"learn/boxes", "ours/boxes", "ours", "theirs"}));
}

TEST_F(SceneSets, ACategoryIsLeftOutOfEverySet) {
  folder_.write("learn.csv", "scene,category\na,boxes\nb,bowls\n");
  folder_.write("ours.csv", "scene,category\nc,bowls\n");
  const std::vector<fs::path> scenes{scene("learn/a"), scene("learn/b"), scene("ours/c"), scene("theirs/d")};
  const LeaveOneOut categories = leave_one_out(scenes, LeftOut::category);
  EXPECT_EQ(categories.left_out, (Names{"boxes", "bowls", "theirs"}));
  EXPECT_EQ(categories.fold, (std::vector<int>{0, 1, 1, 2}));
  const LeaveOneOut sets = leave_one_out(scenes, LeftOut::set);
  EXPECT_EQ(sets.left_out, (Names{"learn", "ours", "theirs"}));
  EXPECT_EQ(sets.fold, (std::vector<int>{0, 0, 1, 2}));
}

TEST_F(SceneSets, OnlyCategoriesAndSetsAreLeftOut) {
  EXPECT_EQ(left_out_named("category"), LeftOut::category);
  EXPECT_EQ(left_out_named("set"), LeftOut::set);
  EXPECT_THROW(left_out_named("scene"), ConfigError);
}

TEST_F(SceneSets, WhatIsTestedIsNotLearnedFrom) {
  folder_.write("ours/a/depth.png", "");
  folder_.write("theirs/b/depth.png", "");
  EXPECT_TRUE(find_additional_scenes({}, {scene("ours/a")}).empty());
  EXPECT_EQ(find_additional_scenes({scene("theirs")}, {scene("ours/a")}), std::vector<fs::path>{scene("theirs/b")});
  EXPECT_THROW(find_additional_scenes({scene("theirs")}, {scene("ours/../theirs/b")}), ConfigError);
}

TEST_F(SceneSets, OneCannotBeLeftOutOfOne) {
  folder_.write("learn.csv", "scene,category\na,boxes\nb,bowls\n");
  EXPECT_NO_THROW(leave_one_out({scene("learn/a"), scene("learn/b")}, LeftOut::category));
  EXPECT_THROW(leave_one_out({scene("learn/a"), scene("learn/b")}, LeftOut::set), ConfigError);
  EXPECT_THROW(leave_one_out({}, LeftOut::set), ConfigError);
  try {
    leave_one_out({scene("learn/a")}, LeftOut::category);
    FAIL() << "one category was taken";
  } catch (const ConfigError& error) {
    const std::string told = error.what();
    EXPECT_NE(told.find("boxes"), std::string::npos) << told;
    EXPECT_NE(told.find(scene("learn").string() + ".csv"), std::string::npos) << told;
  }
}

}  // namespace
}  // namespace gestalt
