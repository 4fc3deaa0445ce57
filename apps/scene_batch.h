// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace gestalt::app {

/// Does what there is to do for a scene and gives a line to print.
using SceneWork = std::function<std::string(const std::filesystem::path&)>;

/// Calls work for every scene, for several at once where there are threads, and prints the lines that it gives in the
/// order of the scenes. A scene that fails is reported on stderr and does not stop the others. With more than one scene
/// and stderr on a terminal a progress bar is shown. Gives the exit code: success, run_failed when some scenes failed.
/// What the only scene throws is passed on, so that the exit code says why. After SIGINT or SIGTERM no scene is begun;
/// those in progress are finished, and the exit code is 128 + the signal's number, as a shell tells that of a killed
/// process.
int for_each_scene(const std::vector<std::filesystem::path>& scenes, const SceneWork& work);

/// What to report of a scene that failed: an error that is not one of ours, such as no memory, does not name it.
std::string failure_message(const std::filesystem::path& scene, const std::exception& error);

}  // namespace gestalt::app
