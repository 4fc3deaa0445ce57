// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/scene_names.h"

#include <gtest/gtest.h>

#include "gestalt/core/base/error.h"

namespace gestalt {
namespace {

std::string complaint(const std::vector<NamedScene>& scenes) {
  try {
    check_scene_names(scenes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SceneNames, AreDistinct) {
  EXPECT_EQ(complaint({}), "");
  EXPECT_EQ(complaint({{"a/1.png", "1"}, {"a/2.png", "2"}}), "");
  EXPECT_EQ(
      complaint({{"a/1.png", "1"}, {"a/2.png", "2"}, {"b/1.png", "1"}}),
      "b/1.png: has the same name as a/1.png, '1', so that one would replace the other; give them apart or rename "
      "one");
  EXPECT_EQ(complaint({{"a/1.png", "1"}, {"a/1.png", "1"}}), "a/1.png: is given twice; remove one");
}

TEST(SceneNames, AreThoseOfFoldersBelowTheOutput) {
  for (const char* name : {"", ".", "..", "../a", "a/b", "/a"})
    EXPECT_NE(complaint({{"x", name}}).find("which cannot be used for a folder of results"), std::string::npos) << name;
  EXPECT_NE(complaint({{"x", std::string("a\0b", 3)}}), "");
  EXPECT_EQ(complaint({{"x", "..."}}), "");
}

}  // namespace
}  // namespace gestalt
