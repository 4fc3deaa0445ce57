// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// FNV-1a of 64 bits as 16 hexadecimal digits: tells contents apart, protects from no one who means harm.
GESTALT_EXPORT std::string content_hash(std::string_view bytes);

}  // namespace gestalt
