// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "gestalt/io/scene/pcd_header.h"

namespace gestalt {

/// Takes a word of an ascii cloud for a value of the field's type and appends its bytes. False when it is none.
bool append_value(std::string_view word, const PcdHeader::Field& field, std::string& points);

}  // namespace gestalt
