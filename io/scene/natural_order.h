// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gestalt {

/// Order of names in which numbers compare by value: learn2 < learn10.
bool natural_less(const std::string& a, const std::string& b);

}  // namespace gestalt
