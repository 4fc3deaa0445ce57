// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <exception>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace gestalt::app {

/// Calls work for every scene in order and prints the line that it gives. A scene that fails is reported on stderr and
/// does not stop the others. With more than one scene and stderr on a terminal a progress bar is shown. Gives the exit
/// code: success, run_failed when some scenes failed; rethrows when the only scene failed, so that the exit code tells
/// why.
int for_each_scene(const std::vector<std::filesystem::path>& scenes,
                   const std::function<std::string(const std::filesystem::path&)>& work);

}  // namespace gestalt::app
