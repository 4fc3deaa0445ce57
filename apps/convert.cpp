// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/convert.h"

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "command.h"
#include "gestalt/error.h"
#include "scene_batch.h"

namespace gestalt::app {

namespace {

namespace fs = std::filesystem;

struct Options {
  fs::path input;
  std::string from;
  std::string labels;  ///< empty: parts
  fs::path output;
  fs::path camera;
};

/// How the scenes of one layout are found and read. A scene goes by the path that names it in messages.
struct Source {
  std::vector<fs::path> scenes;
  std::function<ConvertedScene(const fs::path&)> read;
};

Source open(const Options& options) {
  const auto camera = options.camera.empty() ? std::nullopt : std::optional(read_camera(options.camera));
  if (options.from == "pcd") {
    const LabelKind labels = options.labels == "objects" ? LabelKind::objects : LabelKind::parts;
    std::vector<fs::path> clouds = find_scenes({options.input});
    for (const fs::path& cloud : clouds)
      if (fs::is_directory(cloud)) throw InputError(cloud.string() + ": is a scene folder already; give .pcd files");
    return {std::move(clouds), [=](const fs::path& cloud) { return read_labelled_cloud(cloud, labels, camera); }};
  }
  const fs::path disparity = options.input / "disparity";
  std::vector<fs::path> scenes;
  for (const std::string& name : find_osd_scenes(options.input)) scenes.push_back(disparity / (name + ".png"));
  return {std::move(scenes),
          [=](const fs::path& scene) { return read_osd_scene(options.input, scene_name(scene), camera); }};
}

int convert(const Options& options) {
  const Source source = open(options);
  std::map<std::string, std::map<std::string, std::string>> categories;  // of the scenes of each set
  std::mutex categories_in_use;
  const int code = for_each_scene(source.scenes, [&](const fs::path& path) {
    const std::string name = scene_name(path);
    const ConvertedScene scene = source.read(path);
    const auto [set, category] = osd_scene(name);
    const fs::path folder = options.output / set / name;
    write_scene_folder(folder, scene.images, scene.camera);
    if (!category.empty()) {
      const std::lock_guard lock(categories_in_use);
      categories[set][name] = category;
    }
    return folder.string() + ": " + std::to_string(scene.objects) + " objects" +
           (category.empty() ? "" : ", " + category);
  });
  for (const auto& [set, of_scenes] : categories) merge_categories(options.output / (set + ".csv"), of_scenes);
  return code;
}

}  // namespace

void add_convert(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("convert", "Turn labelled data of another layout into scenes");
  command
      ->add_option("input", options->input,
                   "osd: the folder with image_color, disparity and annotation. pcd: a PCD file or a folder of them")
      ->required()
      ->type_name("INPUT");
  command
      ->add_option("--from", options->from,
                   "Layout of the input: osd, the original release of the Object Segmentation Database; pcd, clouds "
                   "with a label for each point")
      ->required()
      ->check(CLI::IsMember({"osd", "pcd"}));
  command
      ->add_option("--labels", options->labels,
                   "What labels of clouds count: parts (1 to 9 background, 20 to 29 the first object, ...; the "
                   "default) or objects (0 background, 1 the first object, ..., as in the clouds of OSD 0.2)")
      ->check(CLI::IsMember({"parts", "objects"}));
  command
      ->add_option("--output", options->output,
                   "Folder for learn/<scene>/{rgb,depth,label}.png and camera.yaml, learn.csv with the categories, and "
                   "the same for test; scenes whose name is neither learnN nor testN go to scenes/")
      ->check(not_empty)
      ->required()
      ->type_name("DIR");
  command
      ->add_option("--camera", options->camera,
                   "Intrinsics of the images; without it those of OSD, or of the camera.yaml of a cloud")
      ->type_name("FILE");
  command->footer(
      "Example: gestalt convert OSD-0.2-depth --from osd --output osd\n"
      "         gestalt reproduce osd --output report");
  command->callback([options, &run] {
    if (options->from != "pcd" && !options->labels.empty())
      throw CLI::ValidationError("--labels", "is for --from pcd; the annotation of OSD counts objects");
    run = [options] { return convert(*options); };
  });
}

}  // namespace gestalt::app
