// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "result_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "gestalt/core/base/digest.h"
#include "gestalt/tests/environment/temporary_folder.h"

namespace gestalt::test {
namespace {

class KeptResult : public testing::Test {
 protected:
  KeptResult() {
    result.scores = {{"boxes", 3, 7, 0.1, 1.0 / 3, 0.5, 0.25, 1}, {"all", 3, 7, 0.1, 1.0 / 3, 0.5, 0.25, 1}};
    result.structural = {5, 9, 0.125};
    result.assembly.balanced_error = std::numeric_limits<double>::quiet_NaN();
    result.structural_values = {{"r_co", std::numeric_limits<double>::infinity()}, {"r_rs", 1e-300}};
    result.learn = {{"all", 3, 7, 20, 5, 100, 2}};
    result.objects = {{"learn3", "boxes", 0.75, 1}};
    result.further = {{"elsewhere", 2, 5, 0.25, 0.5, 0.125, 0, 0}};
  }
  std::optional<ExperimentResult> read(const std::string& key = "key\n") {
    return ResultFile(folder.path(), key).read([&](const std::string& message) { warnings.push_back(message); });
  }
  std::filesystem::path file() const { return folder.path() / (digest("key\n") + ".json"); }

  const TemporaryFolder folder;
  ExperimentResult result;
  std::vector<std::string> warnings;
};

TEST_F(KeptResult, ReadsBackAsItWas) {
  EXPECT_FALSE(read());
  ResultFile(folder.path(), "key\n").write(result);
  const auto again = read();
  ASSERT_TRUE(again);
  EXPECT_EQ(to_json(*again), to_json(result));
  EXPECT_EQ(again->all().recall, 1.0 / 3);
  EXPECT_TRUE(std::isnan(again->assembly.balanced_error));
  EXPECT_TRUE(std::isinf(again->structural_values[0].f_score));
  EXPECT_EQ(again->structural_values[1].f_score, 1e-300);
  EXPECT_FALSE(read("other key\n"));
  EXPECT_TRUE(warnings.empty());
}

TEST_F(KeptResult, IsNotTakenWhenItIsDamaged) {
  ResultFile(folder.path(), "key\n").write(result);
  const std::string text = content(file());
  std::string changed = text, foreign = text;
  changed.replace(changed.find("0.125"), 5, "0.126");
  foreign.replace(foreign.find("key\\n"), 3, "kex");
  std::size_t expected = 0;
  for (const std::string& damaged : {text.substr(0, text.size() / 2), std::string(), changed, foreign,
                                     std::string("{}"), std::string("[1]"), std::string("\x00\xff\x80", 3)}) {
    folder.write(file().filename(), damaged);
    EXPECT_FALSE(read()) << damaged;
    ASSERT_EQ(warnings.size(), ++expected) << damaged;
    EXPECT_NE(warnings.back().find(file().string()), std::string::npos);
  }
}

}  // namespace
}  // namespace gestalt::test
