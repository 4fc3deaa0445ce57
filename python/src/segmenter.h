// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>
#include <tbb/task_arena.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gestalt/core/config/config.h"
#include "gestalt/core/pipeline/pipeline.h"

namespace gestalt::python {

namespace py = pybind11;

/// A config with its components, those in Python included, ready to run in threads of its own.
class Configured {
 public:
  /// components: dictionary of classes by name. threads: 0 for all. Throws ConfigError, PluginError.
  Configured(const std::filesystem::path& config, const std::vector<std::string>& overrides, const py::dict& components,
             int threads);

  const Pipeline& pipeline() const { return *pipeline_; }

  /// ConfigTree::to_json().
  const nlohmann::json& config() const { return config_; }

  /// f() in the pipeline's threads, with the interpreter released.
  template <class F>
  auto run(F f) const {
    const py::gil_scoped_release released;
    return arena_.execute(f);
  }

 private:
  ConfigTree tree_;
  Registry registry_;
  std::unique_ptr<const Pipeline> pipeline_;
  nlohmann::json config_;
  mutable tbb::task_arena arena_;
};

/// The classes gestalt.Pipeline and gestalt.Result, and read_scene.
void bind_segmenter(py::module_& module);

/// The functions train, cross_validate and score.
void bind_learning(py::module_& module);

/// The config that is named, default.yaml for None.
std::filesystem::path config_file(const py::object& config);

/// Texts of one or many.
std::vector<std::filesystem::path> paths(const py::object& paths);

}  // namespace gestalt::python
