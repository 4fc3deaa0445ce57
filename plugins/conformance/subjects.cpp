// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "subjects.h"

#include <optional>

namespace gestalt::conformance {

namespace {
std::optional<Registry> registry;
}

void load_subjects(std::vector<std::filesystem::path> directories) { registry.emplace(std::move(directories)); }

const Registry& subjects() { return *registry; }

std::vector<ComponentInfo> subjects_of(std::string_view kind) {
  std::vector<ComponentInfo> chosen;
  for (const ComponentInfo& info : subjects().components())
    if (kind.empty() || info.kind == kind) chosen.push_back(info);
  return chosen;
}

}  // namespace gestalt::conformance
