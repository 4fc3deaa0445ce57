// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/yaml_document.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

namespace gestalt {
namespace {

TEST(YamlDocument, IsTheOneThatIsNotEmpty) {
  for (const char* text :
       {"fx: 1", "---\nfx: 1\n", "---\nfx: 1\n---\n", "---\n---\nfx: 1\n", "fx: 1\n...\n", "%YAML 1.2\n---\nfx: 1"})
    EXPECT_EQ(load_yaml_document(text)["fx"].as<int>(), 1) << text;
  for (const char* text : {"", "---\n", "---\n---\n", "# nothing\n"})
    EXPECT_TRUE(load_yaml_document(text).IsNull()) << text;
}

TEST(YamlDocument, ASecondOneIsRefused) {
  for (const char* text : {"fx: 1\n---\nfx: 2\n", "fx: 1\n...\n---\n[1]\n", "---\n---\n1\n---\n2\n"})
    EXPECT_THROW(load_yaml_document(text), YAML::ParserException) << text;
}

/// Of which yaml-cpp makes documents until the memory is used up.
TEST(YamlDocument, WhatNoDocumentBeginsWithIsRefused) {
  for (const char* text : {",'", ",", "fx: 1\n---\n,'", "]", "}", "fx: 1\n...\n,"})
    EXPECT_THROW(load_yaml_document(text), YAML::Exception) << text;
}

}  // namespace
}  // namespace gestalt
