// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "gestalt/core/base/output_file.h"
#include "gestalt/evaluation/experiment/experiment.h"

namespace gestalt {

/// A finished variant as it is kept in a file: JSON with the key, which is all that the result follows from, and a
/// checksum.
class ResultFile {
 public:
  ResultFile(const OutputPath& store, std::string key);

  /// Nothing when there is no file, or, after a warning, when it is damaged.
  std::optional<ExperimentResult> read(const std::function<void(const std::string&)>& warning) const;

  /// Complete or not at all. Throws OutputError.
  void write(const ExperimentResult& result) const;

 private:
  std::string key_;
  OutputPath file_;
};

}  // namespace gestalt
