// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// What a surface or segment is: a thing, or what things stand on, lean on and are seen against.
enum class Role { object, background };

/// "object" or "background".
GESTALT_EXPORT std::string_view name_of(Role role);

}  // namespace gestalt
