// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iostream>
#include <optional>
#include <streambuf>

namespace gestalt::app {

/// While it lives, control characters that are written to a stream come out as text ("\x1b"), but for ends of lines and
/// tabulators: names of files, keys and columns may come from strangers, and could make a terminal do what they say.
class PlainText : public std::streambuf {
 public:
  explicit PlainText(std::ostream& stream) : stream_(stream), out_(stream.rdbuf(this)) {}
  ~PlainText() override;
  PlainText(const PlainText&) = delete;
  PlainText& operator=(const PlainText&) = delete;

 protected:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override { return out_->pubsync(); }

 private:
  std::ostream& stream_;
  std::streambuf* const out_;
};

/// Plain text on standard error; on standard output where it is a terminal, as other programs need names as they are.
class PlainTerminal {
 public:
  PlainTerminal();

 private:
  PlainText errors_{std::cerr};
  std::optional<PlainText> output_;
};

}  // namespace gestalt::app
