// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "configs.h"

namespace gestalt::bench {

std::filesystem::path bundled_config(const std::string& name) {
  return data_directory() / "configs" / (name + ".yaml");
}

std::vector<std::string> measured_configs() {
  std::vector<std::string> names;
  for (const char* name : {"default", "realtime", "paper"})
    if (std::filesystem::exists(bundled_config(name))) names.emplace_back(name);
  return names;
}

}  // namespace gestalt::bench
