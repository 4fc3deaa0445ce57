// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "config_resolution.h"

namespace gestalt::config {

std::string to_yaml(const Resolution& resolution);
nlohmann::json to_json(const Resolution& resolution);

}  // namespace gestalt::config
