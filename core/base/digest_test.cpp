// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/base/digest.h"

#include <gtest/gtest.h>

#include "gestalt/core/base/error.h"
#include "gestalt/tests/environment/temporary_folder.h"

namespace gestalt {
namespace {

TEST(Digest, IsThatOfTheReferenceImplementation) {
  EXPECT_EQ(digest(""), "99aa06d3014798d86001c324468d497f");  // xxhsum -H2 of an empty file
}

TEST(Digest, OfAFileIsThatOfItsContent) {
  const test::TemporaryFolder folder;
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{1} << 18, std::size_t{700'000}}) {
    std::string bytes(size, 'a');
    for (std::size_t i = 0; i < size; ++i) bytes[i] = char(i * i >> 3);
    EXPECT_EQ(file_digest(folder.write("file", bytes)), digest(bytes)) << size;
  }
}

TEST(Digest, OfWhatIsNoRegularFileIsAnError) {
  const test::TemporaryFolder folder;
  for (const auto& path : {folder.path(), folder.path() / "nothing", std::filesystem::path("/dev/zero")})
    EXPECT_THROW(file_digest(path), InputError) << path;
}

}  // namespace
}  // namespace gestalt
