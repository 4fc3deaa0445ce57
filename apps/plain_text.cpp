// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "plain_text.h"

#include <unistd.h>

#include <string>

namespace gestalt::app {

namespace {

bool is_control(unsigned char c) { return (c < 0x20 && c != '\n' && c != '\t') || c == 0x7f; }

/// Of UTF-8, U+0080 to U+009F are control characters too; a terminal takes no other byte for one.
std::string plain(std::string_view text) {
  constexpr char digits[] = "0123456789abcdef";
  std::string escaped;
  const auto escape = [&](unsigned char c) { escaped += {'\\', 'x', digits[c >> 4], digits[c & 15]}; };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    if (is_control(c)) {
      escape(c);
    } else if (c == 0xc2 && next >= 0x80 && next < 0xa0) {
      escape(next);
      ++i;
    } else {
      escaped += text[i];
    }
  }
  return escaped;
}

}  // namespace

PlainText::~PlainText() { stream_.rdbuf(out_); }

PlainText::int_type PlainText::overflow(int_type c) {
  if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
  const char text = traits_type::to_char_type(c);
  return xsputn(&text, 1) == 1 ? c : traits_type::eof();
}

std::streamsize PlainText::xsputn(const char* text, std::streamsize size) {
  const std::string escaped = plain({text, std::size_t(size)});
  return out_->sputn(escaped.data(), std::streamsize(escaped.size())) == std::streamsize(escaped.size()) ? size : 0;
}

PlainTerminal::PlainTerminal() {
  if (::isatty(STDOUT_FILENO)) output_.emplace(std::cout);
}

}  // namespace gestalt::app
