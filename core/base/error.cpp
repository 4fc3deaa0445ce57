// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/base/error.h"

namespace gestalt {

// Out of line: one vtable and one typeinfo each, in the core, so that they are caught across plugins.
Error::~Error() = default;
ConfigError::~ConfigError() = default;
PluginError::~PluginError() = default;
ModelError::~ModelError() = default;
InputError::~InputError() = default;
TimeError::~TimeError() = default;
OutputError::~OutputError() = default;

}  // namespace gestalt
