// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "difference.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace gestalt {
namespace {

using nlohmann::json;

TEST(FirstDifference, NamesThePlace) {
  const json a = json::parse(R"([{"p": 0.5, "names": ["x", "y"]}, {"p": 1}])");
  const auto changed = [&](const std::string& pointer, const json& value) {
    json b = a;
    b[json::json_pointer(pointer)] = value;
    return first_difference(a, b, "pairs");
  };
  EXPECT_EQ(first_difference(a, a, "pairs"), "");
  EXPECT_EQ(changed("/0/p", 0.5001), "pairs[0].p");
  EXPECT_EQ(changed("/1/p", "1"), "pairs[1].p");
  EXPECT_EQ(changed("/0/names/1", "z"), "pairs[0].names[1]");
  EXPECT_EQ(changed("/0/names/2", "z"), "pairs[0].names");
  EXPECT_EQ(changed("/1/q", 1), "pairs[1].q");
  EXPECT_EQ(first_difference(changed("/1/p", 1), 3, "pairs"), "pairs");
}

TEST(FirstDifference, LeavesAMillionthToOtherMachines) {
  EXPECT_EQ(first_difference(0.5, 0.5 + 1e-8, "p"), "");
  EXPECT_EQ(first_difference(1, 1.0, "p"), "");
  EXPECT_EQ(first_difference(0.0, 1e-10, "p"), "");
  EXPECT_EQ(first_difference(0.5, 0.50001, "p"), "p");
}

}  // namespace
}  // namespace gestalt
