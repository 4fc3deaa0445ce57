// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scene_segmenter.h"

#include <algorithm>
#include <array>

#include "gestalt/apps/commands/command.h"
#include "gestalt/apps/stream/frame_watch.h"
#include "gestalt/core/base/digest.h"
#include "gestalt/core/pipeline/run_identity.h"
#include "gestalt/io/result/result.h"
#include "gestalt/io/scene/labelled_files.h"
#include "gestalt/io/scene/png_codec.h"
#include "resumption.h"

namespace gestalt::app {

namespace {

const std::vector<std::string> debug_names{"normals.png", "signal_patches.png", "surfaces.png", "lines.png",
                                           "graph.png"};

constexpr std::array labelled_kinds{"pcd", "ply", "coco"};

std::string labelled_name(const std::string& kind) { return kind == "coco" ? "coco.json" : "labelled." + kind; }

/// Pictures of what the levels below the segments found, by file name.
std::vector<OutputFile> debug_images(const OutputPath& folder, const Percept& percept, const Graph& graph) {
  const Frame& frame = percept.frame();
  return {{folder / "normals.png", encode_png(draw_normals(percept.patches().normals))},
          {folder / "signal_patches.png", encode_png(draw_patches(percept.patches().labels))},
          {folder / "surfaces.png", encode_png(draw_normals(surface_normals(frame, percept.surfaces())))},
          {folder / "lines.png", encode_png(draw_boundary_lines(*percept.scene))},
          {folder / "graph.png", encode_png(draw_graph(frame, percept.surfaces(), graph))}};
}

/// Labels are those of labels.png; the instances of COCO are the objects.
OutputFile labelled_file(const OutputPath& folder, const std::string& kind, const Frame& frame,
                         const Segmentation& segmentation) {
  if (kind == "pcd") return {folder / labelled_name(kind), encode_pcd(frame, segmentation.labels)};
  if (kind == "ply") return {folder / labelled_name(kind), encode_ply(frame, segmentation.labels)};
  // A scene's name comes from a path, which may be no UTF-8.
  return {folder / labelled_name(kind), coco_instances(object_labels(segmentation), frame.name + ".png")
                                                .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) +
                                            "\n"};
}

}  // namespace

void add_segmenter_options(CLI::App& command, SegmenterOptions& options) {
  command.add_option("--output", options.output, "Folder for the results, one folder for each scene")
      ->capture_default_str()
      ->type_name("DIR");
  add_reading_options(command, options.reading);
  command.add_flag(
      "--debug-images", options.debug_images,
      "Also write what each level found: normals.png, signal_patches.png, surfaces.png, lines.png, graph.png");
  command
      .add_option("--also", options.also,
                  "Also write files for other programs: pcd (labelled.pcd, an organized cloud with labels), ply "
                  "(labelled.ply), coco (coco.json, objects as instances with masks)")
      ->check(CLI::IsMember(std::vector<std::string>(labelled_kinds.begin(), labelled_kinds.end())))
      ->delimiter(',')
      ->type_name("KIND,...");
  add_shorthands(command, options.pipeline);
  add_pipeline_options(command, options.pipeline);
}

SceneSegmenter::SceneSegmenter(const SegmenterOptions& options)
    : output_(options.output),
      debug_images_(options.debug_images),
      also_(options.also.begin(), options.also.end()),
      read_(read_options(options.reading)),
      segmenter_(load_segmenter(options.pipeline)),
      config_(segmenter_.config_json()) {
  std::string reading = text_of(options.reading);
  for (const std::filesystem::path& file : {options.reading.camera, options.reading.colour})
    if (!file.empty()) reading += ' ' + file_digest(file);
  run_ = run_identity(segmenter_.loaded()) + reading;
  if (depth_only_may_replace(options.pipeline)) depth_only_.emplace(options.pipeline, reading);
}

SegmentedScene SceneSegmenter::segment(const std::filesystem::path& scene, SceneTracker* tracker) const {
  std::error_code ignored;
  if (also_.contains("coco") && std::filesystem::equivalent(folder_of(scene), scene, ignored))
    throw OutputError((folder_of(scene) / labelled_name("coco")).string() +
                      ": would count as ground truth in the scene's own folder; choose another --output");
  const std::string content = scene_identity(scene);  // of files that are read later: one that changes now is seen
  Input input = read_and_warn(scene, read_);
  const bool depth_only = depth_only_ && !input.frame.has_colour();
  if (depth_only) input.notes.push_back(depth_only_->note(scene));
  const Segmenter& segmenter = depth_only ? depth_only_->segmenter() : segmenter_;
  std::optional<FrameWatch> watch(std::in_place, segmenter.config().time_budget, scene.string());
  const SegmentedFrame found = segmenter.segment(input.frame);
  watch.reset();
  const OutputPath folder = OutputPath(output_) / scene_name(scene);
  remove_abandoned(folder);
  if (const auto& level = found.percept.left_out) {
    const std::string note = std::string("its time was over: decided without relations from the ") + name_of(*level) +
                             " level on (on_timeout: coarse)";
    input.notes.push_back(note);
    std::cerr << "gestalt: note: " + scene.string() + ": " + note + "\n";
  }
  const Segmentation& segmentation = found.segmentation;
  std::vector<OutputFile> more;
  if (debug_images_) more = debug_images(folder, found.percept, segmentation.graph);
  for (const std::string& kind : also_) more.push_back(labelled_file(folder, kind, input.frame, segmentation));
  nlohmann::json config = depth_only ? depth_only_->config() : config_;
  config["identity"] = digest((depth_only ? depth_only_->run() : run_) + content);
  const nlohmann::json tracks = tracker ? tracker->update(scene_name(scene), found) : nlohmann::json();
  write_result(folder, input, found, config, std::move(more), tracker ? &tracks : nullptr);
  const auto objects = std::count_if(segmentation.segments.begin(), segmentation.segments.end(),
                                     [](const Segment& segment) { return segment.role == Role::object; });
  return {folder.path(), std::size_t(objects), found.percept.surfaces().surfaces.size(), found.times.total(), tracks};
}

std::filesystem::path SceneSegmenter::folder_of(const std::filesystem::path& scene) const {
  return output_ / scene_name(scene);
}

bool SceneSegmenter::has_segmented(const std::filesystem::path& scene) const {
  std::vector<std::string> wanted;
  if (debug_images_) wanted = debug_names;
  for (const std::string& kind : also_) wanted.push_back(labelled_name(kind));
  const std::string content = scene_identity(scene);
  const auto by = [&](const std::string& run) { return is_segmented(folder_of(scene), digest(run + content), wanted); };
  return by(run_) || (depth_only_ && by(depth_only_->run()));
}

}  // namespace gestalt::app
