// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "texture_quantity.h"

GESTALT_PLUGIN(gestalt::component<gestalt::TextureQuantity>("texture_quantity", "1.0.0",
                                                            "r_tr: difference of the amounts of texture"))
