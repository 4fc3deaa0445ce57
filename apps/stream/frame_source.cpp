// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "frame_source.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "folder_source.h"
#include "gestalt/core/base/error.h"
#include "gestalt/io/bag/bag.h"
#include "gestalt/io/scene/scene_path.h"
#include "line_source.h"

namespace gestalt::app {

namespace fs = std::filesystem;

std::unique_ptr<FrameSource> open_source(const fs::path& source, bool follow) {
  if (follow && !fs::is_directory(source))
    throw ConfigError("--follow: " + source.string() +
                      " is not a folder; omit --follow, a file or pipe is read until its writer closes it");
  if (source == "-") return std::make_unique<LineSource>(STDIN_FILENO, "standard input", fs::path());
  if (fs::exists(source) && is_scene(source))
    throw InputError(source.string() +
                     ": is a scene, not a source of scenes; give the folder that contains it, or use " +
                     "'gestalt segment'");
  if (source != "-" && is_bag(source))
    throw InputError(source.string() + ": is a recording of ROS; make scenes of it with `gestalt convert " +
                     source.string() + " --output DIR`, then give DIR/scenes");
  if (fs::is_directory(source)) return std::make_unique<FolderSource>(source, follow);
  // A named pipe without a writer must not block here, where no signal would be noticed.
  const int file = ::open(source.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0)
    throw InputError(source.string() + ": cannot be read: " + std::strerror(errno) +
                     "; give a folder of scenes, a file with one path a line, or - for standard input");
  return std::make_unique<LineSource>(file, source.string(), source.parent_path());
}

}  // namespace gestalt::app
