// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "display.h"

#include <X11/Xlib.h>  // a file of its own: its macros break other headers

#include <cstdlib>
#include <string>

#include "gestalt/core/base/error.h"

namespace gestalt::view {

DisplayConnection::DisplayConnection() : display_(XOpenDisplay(nullptr)) {
  if (display_ == nullptr)
    throw OutputError(std::string("no window can be opened: ") +
                      (std::getenv("DISPLAY") ? "the display that $DISPLAY names does not answer"
                                              : "there is no display ($DISPLAY is not set)") +
                      "; gestalt inspect writes a page for a browser instead");
}

DisplayConnection::~DisplayConnection() { XCloseDisplay(static_cast<Display*>(display_)); }

}  // namespace gestalt::view
