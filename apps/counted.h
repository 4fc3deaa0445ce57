// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace gestalt::app {

/// "1 object", "2 objects"; "patches".
inline std::string counted(std::size_t count, const std::string& noun) {
  const std::string plural = noun.ends_with("ch") ? "es" : "s";
  return std::to_string(count) + " " + noun + (count == 1 ? "" : plural);
}

}  // namespace gestalt::app
