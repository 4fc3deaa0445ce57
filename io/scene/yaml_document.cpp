// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/yaml_document.h"

#include <yaml-cpp/yaml.h>

#include <vector>

namespace gestalt {

YAML::Node load_yaml_document(const std::string& text) {
  const std::vector<YAML::Node> documents = YAML::LoadAll(text);
  YAML::Node only;
  for (const YAML::Node& document : documents) {
    if (document.IsNull()) continue;
    if (!only.IsNull())
      throw YAML::ParserException(document.Mark(), "a second document begins here; write it into a file of its own");
    only = document;
  }
  return only;
}

}  // namespace gestalt
