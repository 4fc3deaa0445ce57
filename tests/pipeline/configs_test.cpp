// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// The configs that are installed, with the plugins of this build.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "gestalt/core/pipeline/segmenter.h"

namespace gestalt {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

Pipeline pipeline_of(const fs::path& file) {
  const LoadedConfig loaded(ConfigTree(file, {}));
  return {loaded.config, loaded.registry};
}

fs::path configs() { return default_config().parent_path(); }

/// Values of Tables 2 and 3 of the paper.
const Names& table_values(Level level) {
  static const Names structural{"r_co", "r_rs", "r_tr", "r_ga", "r_fo", "r_co3", "r_cu3", "r_cv3", "r_di2", "r_vd2"};
  static const Names assembly{"r_co", "r_rs", "r_tr", "r_ga", "r_fo", "r_md", "r_nm", "r_nv",
                              "r_ac", "r_dn", "r_cs", "r_oc", "r_ls", "r_as", "r_lg"};
  return level == Level::structural ? structural : assembly;
}

TEST(Configs, AllAreValid) {
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(configs())) {
    if (entry.path().extension() != ".yaml") continue;
    EXPECT_NO_THROW(pipeline_of(entry.path())) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 54);
}

TEST(Configs, ThoseThatNameAModelHaveIt) {
  for (const char* name : {"default.yaml", "realtime.yaml", "depth_only.yaml", "structural.yaml", "paper.yaml"}) {
    const Pipeline pipeline = pipeline_of(configs() / name);
    ASSERT_NO_THROW(pipeline.load_models()) << name;
    const Models models = pipeline.load_models();
    EXPECT_EQ(models.structural.config_hash, config_hash(pipeline.config(), Level::structural))
        << name << ": run scripts/train_models";
    ASSERT_EQ(models.assembly.has_value(), pipeline.config().with_assembly) << name;
    if (!models.assembly) continue;
    EXPECT_EQ(models.assembly->config_hash, config_hash(pipeline.config(), Level::assembly))
        << name << ": run scripts/train_models";
  }
}

TEST(Configs, ThePaperHasTheRelationsOfItsTables) {
  const Pipeline paper = pipeline_of(configs() / "paper.yaml");
  for (const Level level : {Level::structural, Level::assembly})
    EXPECT_EQ(paper.expected_model(level).names, table_values(level)) << name_of(level);
}

TEST(Configs, EachRowOfTheTablesHasItsTwoAblations) {
  for (const Level level : {Level::structural, Level::assembly})
    for (const std::string& value : table_values(level)) {
      const std::string folder = (configs() / "ablation" / name_of(level)).string();
      const Pipeline only = pipeline_of(folder + "_only_" + value + ".yaml");
      EXPECT_EQ(only.expected_model(level).names, Names{value});
      EXPECT_EQ(only.config().with_assembly, level == Level::assembly);
      Names others = table_values(level);
      std::erase(others, value);
      const Pipeline without = pipeline_of(folder + "_without_" + value + ".yaml");
      EXPECT_EQ(without.expected_model(level).names, others);
      EXPECT_EQ(without.config().with_assembly, level == Level::assembly);
    }
}

}  // namespace
}  // namespace gestalt
