// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "declared_size.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace gestalt {
namespace {

using namespace std::string_literals;

std::string number(std::uint32_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += char(value >> (8 * i));
  return bytes;
}

std::string attribute(const std::string& name, const std::string& type, const std::string& value) {
  return name + '\0' + type + '\0' + number(std::uint32_t(value.size())) + value;
}

std::string channel(const std::string& name) { return name + '\0' + std::string(16, '\1'); }

/// An EXR header of 3x2 pixels, with these attributes beside the data window.
std::string exr(const std::string& attributes, char flags = 0) {
  return "\x76\x2f\x31\x01\x02"s + flags + "\0\0"s + attributes +
         attribute("dataWindow", "box2i", number(0) + number(0) + number(2) + number(1)) + '\0';
}

std::optional<cv::Size> size_of_exr(const std::string& bytes) { return declared_size(bytes, ImageKind::exr); }

TEST(DeclaredSize, OfAnExrFileIsItsDataWindow) {
  const std::string file = exr(attribute("channels", "chlist", channel("Y") + channel("Z") + '\0') +
                               attribute("comments", "string", "a table") +
                               attribute("views", "stringvector", number(2) + "ab" + number(0)) +
                               attribute("preview", "preview", number(1) + number(2) + "12345678"));
  EXPECT_EQ(size_of_exr(file), cv::Size(3, 2));
  EXPECT_EQ(exr_channels(file), 2U);
}

TEST(DeclaredSize, IsNothingWhereOpenExrReadsOtherBytesOfAValueThanItDeclares) {
  EXPECT_FALSE(size_of_exr(exr(attribute("channels", "chlist", channel("Y")))));
  EXPECT_FALSE(size_of_exr(exr(attribute("channels", "chlist", channel("Y") + "\0more"s))));
  EXPECT_FALSE(size_of_exr(exr(attribute("channels", "chlist", "Y\0short"s))));
  EXPECT_FALSE(size_of_exr(exr(attribute("pixelAspectRatio", "float", "12345"))));
  EXPECT_FALSE(size_of_exr(exr(attribute("preview", "preview", number(1) + number(3) + "12345678"))));
  EXPECT_FALSE(size_of_exr(exr(attribute("views", "stringvector", number(3) + "ab"))));
}

TEST(DeclaredSize, IsNothingForExrFilesOfSeveralPartsAndDeepPixels) {
  for (const char flags : {'\x08', '\x10'}) {
    EXPECT_FALSE(size_of_exr(exr("", flags)));
    EXPECT_FALSE(is_flat_exr(exr("", flags)));
  }
  EXPECT_TRUE(is_flat_exr(exr("")));
}

}  // namespace
}  // namespace gestalt
