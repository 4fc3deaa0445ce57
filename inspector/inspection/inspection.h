// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gestalt/core/pipeline/segmenter.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

/// Computes a scene again and gives everything that the Inspector's page shows of it; docs/inspector.md explains what
/// each thing means, inspector/README.md how it is stored. stored is the scene's result.json, segmenter that of its
/// config or of what replaces it. Where the two results differ, "notes" tells the first difference. Deterministic for
/// any number of threads. Throws as Segmenter does.
nlohmann::json inspect_scene(const nlohmann::json& stored, const Input& input, const Segmenter& segmenter);

/// The page of one or several scenes, each as inspect_scene() gives it: one HTML file that needs nothing else. What is
/// in them may be untrusted and cannot act as code. Throws ConfigError when the page's template, of
/// data_directory(), is not there.
std::string inspector_page(std::vector<nlohmann::json> scenes);

}  // namespace gestalt
