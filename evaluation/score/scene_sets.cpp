// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/score/scene_sets.h"

#include <algorithm>
#include <map>
#include <set>

#include "gestalt/core/base/error.h"
#include "gestalt/evaluation/score/evaluation.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

/// The folder that a scene is in.
fs::path folder_of(const fs::path& scene) {
  const fs::path path = fs::absolute(scene).lexically_normal();
  return path.has_filename() ? path.parent_path() : path.parent_path().parent_path();
}

/// The last names of a path, joined by '/'; all of it when it has no more.
std::string last_names(fs::path path, int count) {
  fs::path name = path.filename();
  while (--count > 0 && path.has_relative_path()) {
    path = path.parent_path();
    name = path.filename() / name;
  }
  return name.generic_string();
}

bool differ(const std::map<fs::path, std::string>& names) {
  std::set<std::string> different;
  for (const auto& [folder, name] : names) different.insert(name);
  return different.size() == names.size();
}

std::vector<std::string> categories_or_sets(const std::vector<fs::path>& scenes) {
  std::vector<std::string> names = scene_categories(scenes);
  const std::vector<std::string> sets = scene_sets(scenes);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i].empty()) names[i] = sets[i];
  return names;
}

}  // namespace

std::vector<std::string> scene_sets(const std::vector<fs::path>& scenes) {
  std::map<fs::path, std::string> names;
  for (const fs::path& scene : scenes) names[folder_of(scene)];
  int count = 0;
  do {
    ++count;
    for (auto& [folder, name] : names) name = last_names(folder, count);
  } while (!differ(names));
  std::vector<std::string> sets;
  for (const fs::path& scene : scenes) sets.push_back(names[folder_of(scene)]);
  return sets;
}

std::vector<std::string> scene_categories(const std::vector<fs::path>& scenes) {
  std::map<fs::path, std::map<std::string, std::string>> known;
  std::vector<std::string> categories;
  for (const fs::path& scene : scenes) {
    const fs::path file = folder_of(scene).string() + ".csv";
    if (!known.contains(file)) known.emplace(file, read_categories(file));
    const auto found = known[file].find(scene_name(scene));
    categories.push_back(found == known[file].end() ? "" : found->second);
  }
  return categories;
}

std::vector<std::string> scene_rows(const std::vector<fs::path>& scenes) {
  std::vector<std::string> rows = scene_categories(scenes);
  const std::vector<std::string> sets = scene_sets(scenes);
  if (std::adjacent_find(sets.begin(), sets.end(), std::not_equal_to<>()) == sets.end()) return rows;
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = rows[i].empty() ? sets[i] : sets[i] + "/" + rows[i];
  return rows;
}

LeftOut left_out_named(std::string_view name) {
  const auto found = std::find(left_out_names.begin(), left_out_names.end(), name);
  if (found == left_out_names.end())
    throw ConfigError("leave one out: '" + std::string(name) + "' cannot be left out; give category or set");
  return LeftOut(found - left_out_names.begin());
}

LeaveOneOut leave_one_out(const std::vector<fs::path>& scenes, LeftOut what) {
  LeaveOneOut folds;
  for (const std::string& name : what == LeftOut::set ? scene_sets(scenes) : categories_or_sets(scenes)) {
    const auto found = std::find(folds.left_out.begin(), folds.left_out.end(), name);
    folds.fold.push_back(int(found - folds.left_out.begin()));
    if (found == folds.left_out.end()) folds.left_out.push_back(name);
  }
  if (folds.left_out.size() >= 2) return folds;
  const std::string only = folds.left_out.empty() ? "" : ", " + folds.left_out[0];
  throw ConfigError(
      what == LeftOut::set
          ? "leave one set out: all scenes belong to one set" + only + "; give at least two folders of scenes"
          : "leave one category out: all scenes belong to one category" + only + "; name two or more in " +
                (scenes.empty() ? fs::path("FOLDER") : folder_of(scenes[0])).string() +
                ".csv (columns scene and category), or give several sets");
}

std::vector<fs::path> find_additional_scenes(const std::vector<fs::path>& paths, const std::vector<fs::path>& tested) {
  std::vector<fs::path> additional = find_scenes(paths);
  std::set<fs::path> held_out;
  for (const fs::path& scene : tested) held_out.insert(fs::weakly_canonical(scene));
  for (const fs::path& scene : additional)
    if (held_out.contains(fs::weakly_canonical(scene)))
      throw ConfigError(scene.string() +
                        ": is both a test scene and a training scene in every fold; give it only once");
  return additional;
}

}  // namespace gestalt
