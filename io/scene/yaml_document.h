// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "gestalt/core/base/export.h"

namespace YAML {
class Node;
}

namespace gestalt {

/// The one document of a YAML text; empty ones, as `rostopic echo` leaves behind its separator, do not count. Throws
/// YAML::Exception, for a second document too, which YAML::Load() would leave out in silence.
GESTALT_EXPORT YAML::Node load_yaml_document(const std::string& text);

}  // namespace gestalt
