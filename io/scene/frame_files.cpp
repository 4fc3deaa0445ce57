// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "frame_files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "associations.h"
#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/image_file.h"
#include "natural_order.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 3> colour_words{"rgb", "color", "colour"};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

bool has(const std::string& text, std::string_view word) { return text.find(word) != text.npos; }

bool is_depth(const std::string& name) { return has(name, "depth"); }

/// image: a word of last resort.
bool is_colour(const std::string& name) {
  return !is_depth(name) && (std::any_of(colour_words.begin(), colour_words.end(),
                                         [&](std::string_view word) { return has(name, word); }) ||
                             has(name, "image"));
}

/// The entries of a folder that keep() wants, in natural order; none where it cannot be listed.
template <class Keep>
std::vector<fs::path> entries(const fs::path& folder, const Keep& keep) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error))
    if (!entry->path().filename().string().starts_with('.') && keep(entry->path())) found.push_back(entry->path());
  std::sort(found.begin(), found.end(),
            [](const fs::path& a, const fs::path& b) { return natural_less(a.string(), b.string()); });
  return found;
}

bool is_image(const fs::path& path) {
  std::error_code ignored;
  return has_image_extension(path) && !fs::is_directory(path, ignored);
}

std::vector<fs::path> images_in(const fs::path& folder) { return entries(folder, is_image); }

/// A folder of the recording whose name means(): of several the one with the shortest name, "depth" before "depth_raw".
template <class Means>
fs::path folder_in(const fs::path& recording, const Means& means) {
  std::vector<fs::path> found = entries(recording, [&](const fs::path& path) {
    std::error_code ignored;
    return means(lower(path.filename().string())) && fs::is_directory(path, ignored);
  });
  const auto shortest = std::min_element(found.begin(), found.end(), [](const fs::path& a, const fs::path& b) {
    return a.filename().string().size() < b.filename().string().size();
  });
  return shortest == found.end() ? fs::path() : *shortest;
}

/// The digits that come first in a name, without zeros before them: "17" of frame-000017.depth.
std::string number_in(const std::string& name) {
  const std::size_t first = name.find_first_of("0123456789");
  if (first == name.npos) return "";
  const std::string digits = name.substr(first, name.find_first_not_of("0123456789", first) - first);
  return digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1));
}

/// The names that the colour image of a depth image may have, without extension.
std::vector<std::string> colour_stems(const std::string& depth_stem) {
  std::vector<std::string> stems{depth_stem};
  const std::size_t at = depth_stem.rfind("depth");
  if (at == depth_stem.npos) return stems;
  std::vector<std::string_view> words(colour_words.begin(), colour_words.end());
  words.insert(words.end(), {"image", "img"});
  for (const std::string_view word : words) {
    stems.push_back(depth_stem);
    stems.back().replace(at, 5, word);
  }
  // 000001_depth.png beside 000001.png
  const std::size_t end = depth_stem.find_last_not_of("-_.", at == 0 ? 0 : at - 1);
  if (at > 0 && end != depth_stem.npos) stems.push_back(depth_stem.substr(0, end + 1) + depth_stem.substr(at + 5));
  return stems;
}

/// Of these images the one that belongs to a depth image, by its name; all are absolute.
fs::path named_alike(const fs::path& depth, const std::vector<fs::path>& images) {
  for (const std::string& stem : colour_stems(lower(depth.stem().string())))
    for (const fs::path& image : images)
      if (image != depth && lower(image.stem().string()) == stem && !is_depth_image(image)) return image;
  return {};
}

fs::path only_of_number(const fs::path& depth, const std::vector<fs::path>& images) {
  const std::string number = number_in(depth.stem().string());
  fs::path found;
  for (const fs::path& image : images) {
    if (number.empty() || number_in(image.stem().string()) != number) continue;
    if (!found.empty()) return {};
    found = image;
  }
  return found;
}

fs::path colour_by_lists(const fs::path& depth, const fs::path& recording) {
  std::error_code ignored;
  for (const FrameFiles& frame : associated_images(recording))
    if (frame.depth.lexically_normal() == depth.lexically_normal() || fs::equivalent(frame.depth, depth, ignored))
      return frame.colour;
  return {};
}

}  // namespace

FrameFiles files_of_scene_folder(const fs::path& folder) {
  std::error_code ignored;
  FrameFiles files{folder / "depth.png", folder / "rgb.png"};
  if (fs::exists(files.depth, ignored) && fs::exists(files.colour, ignored)) return files;
  const std::vector<fs::path> images = images_in(folder);
  const auto the_only = [&](const auto& names) {
    fs::path found;
    for (const fs::path& image : images) {
      const std::string stem = lower(image.stem().string());
      if (std::find(names.begin(), names.end(), stem) == names.end()) continue;
      if (!found.empty())
        throw InputError(image.string() + ": and " + found.filename().string() +
                         " could both be the frame's; keep one of them here");
      found = image;
    }
    return found;
  };
  if (!fs::exists(files.depth, ignored)) files.depth = the_only(std::array<std::string_view, 1>{"depth"});
  if (!fs::exists(files.colour, ignored)) files.colour = the_only(colour_words);
  return files;
}

bool has_scene_images(const fs::path& folder) {
  return !entries(folder, [](const fs::path& path) {
            const std::string stem = lower(path.stem().string());
            return (stem == "depth" ||
                    std::find(colour_words.begin(), colour_words.end(), stem) != colour_words.end()) &&
                   is_image(path);
          }).empty();
}

std::vector<fs::path> depth_images(const fs::path& folder) {
  if (has_associations(folder)) {
    std::vector<fs::path> images;
    for (const FrameFiles& frame : associated_images(folder)) images.push_back(frame.depth);
    return images;
  }
  if (const fs::path depth = folder_in(folder, is_depth); !depth.empty()) return images_in(depth);
  return entries(folder, [](const fs::path& path) { return is_image(path) && is_depth(lower(path.stem().string())); });
}

fs::path recording_of(const fs::path& depth) {
  std::error_code ignored;
  const fs::path folder = fs::absolute(depth, ignored).lexically_normal().parent_path();
  // A scene folder may have any name.
  const bool of_images = is_depth(lower(folder.filename().string())) && lower(depth.stem().string()) != "depth";
  return of_images ? folder.parent_path() : folder;
}

FrameFiles files_of_frame(const fs::path& depth) {
  const fs::path recording = recording_of(depth);
  FrameFiles files{depth, {}};
  std::error_code ignored;
  if (has_associations(recording)) files.colour = colour_by_lists(depth, recording);
  if (!files.colour.empty()) return files;
  const fs::path place = fs::absolute(depth, ignored).lexically_normal();
  if (place.parent_path() == recording) {
    files.colour = named_alike(place, images_in(recording));
    return files;
  }
  const fs::path folder = folder_in(recording, is_colour);
  if (folder.empty()) return files;
  const std::vector<fs::path> images = images_in(folder);
  files.colour = named_alike(place, images);
  if (files.colour.empty()) files.colour = only_of_number(place, images);
  if (files.colour.empty() && !images.empty())
    throw InputError(depth.string() + ": which image of " + folder.string() +
                     " is its colour, the names do not tell (" + seen_in(folder) + " there); write " +
                     (recording / "associations.txt").string() +
                     " with lines 'time rgb/FILE time depth/FILE', or give --depth and --rgb");
  return files;
}

std::string seen_in(const fs::path& folder) {
  constexpr std::size_t named = 3;
  const std::vector<fs::path> all = entries(folder, [](const fs::path&) { return true; });
  std::string text;
  for (std::size_t i = 0; i < std::min(all.size(), named); ++i)
    text += (i == 0 ? "" : i + 1 == all.size() ? " and " : ", ") + all[i].filename().string();
  if (all.size() > named) text += " and " + std::to_string(all.size() - named) + " more";
  return text.empty() ? "nothing is" : text + (all.size() > 1 ? " are" : " is");
}

}  // namespace gestalt
