// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "header_line.h"

#include <algorithm>

#include "gestalt/core/base/error.h"
#include "words.h"

namespace gestalt {

void HeaderLine::next() {
  constexpr std::size_t longest = 4096;
  do {
    const std::size_t end = bytes_.find('\n', end_);
    // A line of a header is short: a long one is binary data or another kind of file.
    if (end == bytes_.npos || end - end_ > longest)
      fail("the " + format_ + " header ends here; the file is truncated or not a point cloud, write it again");
    words_ = words_of(bytes_.substr(end_, end - end_));
    end_ = end + 1;
    ++number_;
  } while (words_.empty() || comment_(words_[0]));
}

void HeaderLine::fail(const std::string& what) const {
  throw InputError(file_.string() + ":" + std::to_string(number_) + ": " + what);
}

std::string shown(std::string_view word) {
  std::string text(word.substr(0, 40));
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 32 || c > 126; }, '?');
  return "'" + text + "'";
}

}  // namespace gestalt
