// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "gestalt/core/base/export.h"

namespace gestalt {

// A set is a folder of scenes. A file FOLDER.csv beside it (read_categories() in evaluation.h) gives each scene a
// category.

/// The set of each scene: the name of its folder, with as many parent folders as tell the sets apart: "learn", or
/// "a/learn" and "b/learn".
GESTALT_EXPORT std::vector<std::string> scene_sets(const std::vector<std::filesystem::path>& scenes);

/// The category of each scene; "" where none is given. Throws InputError as read_categories() does.
GESTALT_EXPORT std::vector<std::string> scene_categories(const std::vector<std::filesystem::path>& scenes);

/// The row of the tables that each scene counts in: its category or, where the scenes are of several sets,
/// SET/CATEGORY, and SET where no category is given. Categories of one name in two sets are seldom of one difficulty,
/// as sensors differ; so they are not averaged. Throws InputError.
GESTALT_EXPORT std::vector<std::string> scene_rows(const std::vector<std::filesystem::path>& scenes);

/// What is left out of training at a time, to test on it.
enum class LeftOut { category, set };
inline constexpr std::array<std::string_view, 2> left_out_names{"category", "set"};

/// Throws ConfigError for any other name.
GESTALT_EXPORT LeftOut left_out_named(std::string_view name);

/// A fold for each category or set.
struct LeaveOneOut {
  std::vector<std::string> left_out;  ///< of each fold, in order of first appearance
  std::vector<int> fold;              ///< of each scene

  int folds() const { return int(left_out.size()); }
};

/// Deals the scenes to folds. A category is left out of all sets that have it: a model that has seen it in one of them
/// is not tested on it in another. A scene without category is of a category with the name of its set. Throws
/// ConfigError for less than two folds, InputError.
GESTALT_EXPORT LeaveOneOut leave_one_out(const std::vector<std::filesystem::path>& scenes, LeftOut what);

/// The scenes below some paths that every fold learns from beside the others. Throws ConfigError when one of them is
/// also tested on, InputError as find_scenes() does.
GESTALT_EXPORT std::vector<std::filesystem::path> find_additional_scenes(
    const std::vector<std::filesystem::path>& paths, const std::vector<std::filesystem::path>& tested);

}  // namespace gestalt
