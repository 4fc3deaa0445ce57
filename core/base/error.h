// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// Base of everything the core throws. The message names what was being read, the place in it and the remedy.
class GESTALT_EXPORT Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  ~Error() override;
};

/// A config, a command line or a parameter value is wrong (exit code 2).
class GESTALT_EXPORT ConfigError : public Error {
 public:
  using Error::Error;
  ~ConfigError() override;
};

/// A plugin is missing, was rejected, or broke its contract (exit code 2).
class GESTALT_EXPORT PluginError : public Error {
 public:
  using Error::Error;
  ~PluginError() override;
};

/// A trained model cannot be read or does not fit the config (exit code 2).
class GESTALT_EXPORT ModelError : public Error {
 public:
  using Error::Error;
  ~ModelError() override;
};

/// A scene, cloud, image or camera cannot be used (exit code 3).
class GESTALT_EXPORT InputError : public Error {
 public:
  using Error::Error;
  ~InputError() override;
};

/// A frame took longer than the config's time_budget (exit code 1).
class GESTALT_EXPORT TimeError : public Error {
 public:
  using Error::Error;
  ~TimeError() override;
};

/// A result cannot be written (exit code 1).
class GESTALT_EXPORT OutputError : public Error {
 public:
  using Error::Error;
  ~OutputError() override;
};

}  // namespace gestalt
