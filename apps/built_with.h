// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gestalt::app {

/// Version of the program, and of the compiler and every library that it was built against, a line each.
std::string built_with();

}  // namespace gestalt::app
