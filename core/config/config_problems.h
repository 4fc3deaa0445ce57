// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "config_node.h"

namespace gestalt::config {

/// What is wrong with a config, collected so that all of it is reported at once.
class Problems {
 public:
  /// path is that of the value, e.g. structural.minimum_size; empty when no single value is at fault.
  void add(const Place& place, const std::string& path, const std::string& message);

  /// Throws ConfigError with a line for each problem, sorted by place; remark ends the message.
  void throw_if_any(const std::string& remark = "") const;

 private:
  struct Problem {
    Place place;
    std::string text;
  };
  std::vector<Problem> problems_;
};

}  // namespace gestalt::config
