// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "segmenter.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <Eigen/Geometry>
#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>

#include "arguments.h"
#include "arrays.h"
#include "components.h"
#include "core_call.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/for_all.h"
#include "gestalt/core/pipeline/learning_set.h"
#include "gestalt/core/pipeline/run_identity.h"
#include "gestalt/core/tracking/tracker.h"
#include "gestalt/evaluation/score/evaluation.h"
#include "gestalt/evaluation/score/scene_sets.h"
#include "gestalt/io/result/result.h"
#include "gestalt/io/scene/depth_only.h"
#include "gestalt/io/scene/depth_reading.h"
#include "gestalt/io/scene/input.h"
#include "gestalt/io/scene/reading_names.h"
#include "gestalt/io/scene/scene_names.h"
#include "on_object.h"
#include "text.h"
#include "wording.h"

namespace gestalt::python {

namespace {

namespace fs = std::filesystem;

constexpr const char* config_of_depth = "; config=\"depth_only.yaml\" selects it without this warning";

/// What results need of the segmenter that made them.
struct Source {
  Arena arena;
  nlohmann::json config;  ///< Segmenter::config_json()
};

/// A segmenter, ready to run.
struct Loaded {
  std::shared_ptr<const Source> source;
  Segmenter segmenter;
};

Loaded load(const Arena& arena, LoadedConfig config) {
  Segmenter segmenter = Arena(1).run([&] { return Segmenter(std::move(config)); });  // so that a fork is harmless
  if (const std::string warning = segmenter.warning(); !warning.empty()) warn(warning);
  auto source = std::make_shared<Source>(Source{arena, segmenter.config_json()});
  return {std::move(source), std::move(segmenter)};
}

/// Throws what Python has for other objects, and for a NUL within.
fs::path path_of(const py::handle& path) {
  PyObject* bytes = nullptr;
  if (!PyUnicode_FSConverter(path.ptr(), &bytes)) throw py::error_already_set();
  return std::string(py::reinterpret_steal<py::bytes>(bytes));
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// What was found in a frame. Images share their memory with numpy; the rest is made when it is asked for.
class Result {
 public:
  Result(std::shared_ptr<const Source> source, Input input, SegmentedFrame found)
      : source_(std::move(source)), input_(std::move(input)), found_(std::move(found)) {}

  const Input& input() const { return input_; }
  const SegmentedFrame& found() const { return found_; }
  py::str name() const { return text_of(input_.frame.name); }
  py::array labels() const { return array_of(found_.segmentation.labels); }
  py::array objects_image() const { return array_of(object_labels(found_.segmentation)); }
  py::array patch_labels() const { return array_of(found_.percept.surfaces().labels); }
  py::array normals() const { return array_of(found_.percept.patches().normals); }
  py::array points() const { return array_of(input_.frame.points); }

  /// Of result.json; objects of its own each time, which a user may change.
  py::dict dictionary() { return object_of(content()); }
  py::list segments() { return object_of(content().at("segments")); }
  py::list patches() { return object_of(content().at("patches")); }

  py::object objects() {
    return py::module_::import("gestalt.objects").attr("objects_of")(dictionary(), labels(), points(), normals());
  }

  py::dict pairs(Level level) const {
    const RelationTable& table = found_.percept.table(level);
    const std::size_t rows = table.pairs.size();
    py::array_t<std::int64_t> numbers({rows, std::size_t{2}});
    py::array_t<double> values({rows, table.names.size()}), probabilities{py::ssize_t(rows)};
    std::copy(table.values.begin(), table.values.end(), values.mutable_data());
    for (std::size_t i = 0; i < rows; ++i) {
      numbers.mutable_at(i, 0) = table.pairs[i].a, numbers.mutable_at(i, 1) = table.pairs[i].b;
      probabilities.mutable_at(i) = std::numeric_limits<double>::quiet_NaN();
    }
    for (const Edge& edge : found_.segmentation.graph.edges)
      if (edge.level == level) probabilities.mutable_at(edge.row) = edge.probability;
    py::dict pairs;
    pairs["names"] = table.names;
    pairs["pairs"] = numbers;
    pairs["values"] = values;
    pairs["probabilities"] = probabilities;
    return pairs;
  }

  py::dict milliseconds() const {
    py::dict times;
    times["signal"] = found_.times.signal;
    times["primitive"] = found_.times.primitive;
    times["structural"] = found_.times.structural;
    times["assembly"] = found_.times.assembly;
    times["decision"] = found_.times.decision;
    return times;
  }

  void save(const fs::path& folder, const std::optional<std::string>& name) const {
    if (name && (name->empty() || *name == "."))
      throw OutputError("name: '" + *name + "' is not a name of a folder; leave it out to write to the folder itself");
    const OutputPath place = name ? OutputPath(folder) / *name : OutputPath(folder);
    source_->arena.run([&] { write_result(place, input_, found_, source_->config); });
  }

  /// For pickle: a gestalt.StoredResult of the same content.
  py::tuple reduced() {
    const py::object stored = py::module_::import("gestalt.stored").attr("StoredResult");
    return py::make_tuple(
        stored, py::make_tuple(name(), labels(), objects_image(), patch_labels(), normals(), points(),
                               pairs(Level::structural), pairs(Level::assembly), milliseconds(), dictionary()));
  }

  py::str text() const {
    std::size_t objects = 0;
    for (const Segment& segment : found_.segmentation.segments) objects += segment.role == Role::object;
    return text_of("<gestalt.Result of '" + input_.frame.name + "': " + counted(objects, "object", "objects") + ", " +
                   counted(found_.percept.surfaces().surfaces.size(), "patch", "patches") + ">");
  }

 private:
  /// result.json, made once.
  const nlohmann::json& content() {
    if (content_.is_null()) {
      nlohmann::json content = source_->arena.run([&] { return result_json(input_, found_, source_->config); });
      if (content_.is_null()) content_ = std::move(content);  // else another thread has made it meanwhile
    }
    return content_;
  }

  std::shared_ptr<const Source> source_;
  Input input_;
  SegmentedFrame found_;
  nlohmann::json content_;
};

/// A rigid motion of a (4, 4) array. Throws InputError for anything else.
std::optional<Eigen::Isometry3d> pose_of(const py::object& given) {
  if (given.is_none()) return std::nullopt;
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!array) throw py::error_already_set();
  if (array.ndim() != 2 || array.shape(0) != 4 || array.shape(1) != 4)
    throw InputError("pose: expected an array of shape (4, 4)");
  Eigen::Isometry3d pose;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) pose.matrix()(row, column) = array.at(row, column);
  const Eigen::Matrix3d rotation = pose.linear();
  if (!pose.matrix().allFinite() || !(rotation * rotation.transpose()).isIdentity(0.01) || rotation.determinant() < 0 ||
      !pose.matrix().row(3).isApprox(Eigen::RowVector4d(0, 0, 0, 1)))
    throw InputError("pose: expected a rotation with a translation in metres, and 0 0 0 1 as the last row");
  return pose;
}

py::list changes(const std::vector<FrameTracks::Change>& all) {
  py::list pairs;
  for (const auto& change : all) pairs.append(py::make_tuple(change.from, change.into));
  return pairs;
}

/// gestalt.Tracker.
class PyTracker {
 public:
  explicit PyTracker(int keep) {
    if (keep < 0) throw py::value_error("keep: must be a number of frames, 0 or more");
    TrackerParams params;
    params.keep = keep;
    tracker_ = Tracker(params);
  }

  py::dict update(Self<Result> result, const py::object& given_pose) {
    const auto pose = pose_of(given_pose);
    const SegmentedFrame& found = result.object.found();
    const std::vector<ObjectDescription> objects = describe_objects(found);
    const FrameTracks tracks = tracker_.update(found.percept.frame(), found.segmentation.labels, objects, pose);
    py::dict numbers, all;
    for (std::size_t i = 0; i < objects.size(); ++i) numbers[py::int_(objects[i].label)] = tracks.numbers[i];
    all["numbers"] = numbers;
    all["new"] = tracks.appeared;
    all["hidden"] = tracks.hidden;
    all["lost"] = tracks.lost;
    all["split"] = changes(tracks.split);
    all["merged"] = changes(tracks.merged);
    return all;
  }

 private:
  Tracker tracker_;
};

/// gestalt.Segmenter.
class PySegmenter {
 public:
  PySegmenter(const py::object& config, std::vector<std::string> overrides, const py::dict& components, int threads)
      : overrides_(std::move(overrides)),
        components_(components),
        may_be_replaced_(config.is_none() && depth_only_may_replace({}, overrides_)),
        arena_(threads),
        loaded_(load(arena_, load_config(config, overrides_, components_))),
        name_(config.is_none() ? default_config().filename().string() : path_of(config).string()) {}

  std::unique_ptr<Result> call(const py::object& colour, const py::object& depth, const py::object& given_camera,
                               const std::string& name, std::optional<double> depth_scale,
                               const std::optional<std::string>& depth_kind) const {
    const py::array depth_values = depth_array(depth);
    const Camera camera = camera_of(given_camera);
    cv::Mat colours = colour_image(colour);
    DepthReading depths = depth_image(depth_values, read_options({{}, depth_scale, depth_kind, {}}));
    Input input;
    input.path = name;
    arena_.run([&] { set_frame(input, name, colours, std::move(depths), camera); });
    return segment(std::move(input));
  }

  std::unique_ptr<Result> read(const fs::path& scene, const py::object& camera, std::optional<double> depth_scale,
                               const std::optional<std::string>& depth_kind,
                               const std::optional<std::string>& labels) const {
    const ReadOptions options = read_options({optional_camera(camera), depth_scale, depth_kind, labels});
    return segment(arena_.run([&] { return read_scene(scene, options); }));
  }

  py::object evaluate(const py::object& scenes, std::optional<double> depth_scale,
                      const std::optional<std::string>& depth_kind, const std::optional<std::string>& labels) const {
    const std::vector<fs::path> given = some_paths(scenes);
    const ReadOptions options = read_options({{}, depth_scale, depth_kind, labels});
    const std::vector<fs::path> all = arena_.run([&] { return find_scenes(given); });
    const bool by_depth = may_be_replaced_ && arena_.run([&] { return none_has_colour(all, options); });
    if (by_depth)
      warn(std::string("no scene has a colour image; scored by depth alone, with depth_only.yaml and its model") +
           config_of_depth);
    const Segmenter& segmenter = (by_depth ? depth_only() : loaded_).segmenter;
    std::vector<ImageScore> scores(all.size());
    std::vector<std::vector<std::string>> warnings(all.size());
    std::atomic<std::int64_t> objects = 0;
    arena_.run([&] {
      for_all(all.size(), [&](std::size_t i) {
        require_interpreter();
        const Input input = read_scene(all[i], options);
        warnings[i] = input.warnings;
        if (may_be_replaced_ && !by_depth) require_colour_as_of_others(input);
        const auto ground_truth = scored_ground_truth(input);
        objects += count_objects(ground_truth);
        scores[i] = score_image(ground_truth, segmenter.segment(input.frame).segmentation.labels);
      });
    });
    for (const std::vector<std::string>& of_scene : warnings) warn(of_scene);
    require_objects(objects);
    return object_of(arena_.run([&] { return to_json(with_mean(summarise(scores, scene_rows(all)))); }));
  }

  py::object config() const { return object_of(loaded_.source->config.at("values")); }

  py::str text() const {
    const nlohmann::json& values = loaded_.source->config.at("values");
    return text_of("<gestalt.Segmenter of '" + name_ + "': levels " + values.at("levels").get<std::string>() +
                   ", model '" + fs::path(values.at("model").get<std::string>()).filename().string() + "'>");
  }

 private:
  std::unique_ptr<Result> segment(Input input) const {
    const bool by_depth = may_be_replaced_ && !input.frame.has_colour();
    if (by_depth) {
      input.notes.emplace_back("has no colour image; segmented by depth alone, with depth_only.yaml and its model");
      warn(input.frame.name + ": " + input.notes.back() + config_of_depth);
    }
    const Loaded& loaded = by_depth ? depth_only() : loaded_;
    SegmentedFrame found = arena_.run([&] { return loaded.segmenter.segment(input.frame); });
    warn(input.warnings);
    return std::make_unique<Result>(loaded.source, std::move(input), std::move(found));
  }

  /// What takes the place of the default where there is no colour; loaded when it is asked for first.
  const Loaded& depth_only() const {
    const Released released;  // or the thread with the lock would wait for the interpreter, and this one for the lock
    const std::lock_guard lock(in_use_);
    if (!depth_only_)
      hold_interpreter([&] {
        depth_only_.emplace(load(arena_, load_config(py::cast(depth_only_config()), overrides_, components_)));
      });
    return *depth_only_;
  }

  std::vector<std::string> overrides_;
  py::dict components_;
  bool may_be_replaced_;  ///< by the config for depth alone
  Arena arena_;
  Loaded loaded_;
  std::string name_;  ///< of the config
  mutable std::mutex in_use_;
  mutable std::optional<Loaded> depth_only_;
};

py::tuple read(const fs::path& scene, const py::object& camera, std::optional<double> depth_scale,
               const std::optional<std::string>& depth_kind, const std::optional<std::string>& labels) {
  const ReadOptions options = read_options({optional_camera(camera), depth_scale, depth_kind, labels});
  const Input input = Arena(1).run([&] { return read_scene(scene, options); });
  warn(input.warnings);
  const Frame& frame = input.frame;
  const py::object truth = input.ground_truth.empty() ? py::object(py::none()) : array_of(input.ground_truth);
  return py::make_tuple(text_of(frame.name), colour_array(frame.colour), array_of(frame.depth), frame.camera, truth);
}

/// The value of a name. Throws InputError that lists the names.
template <class Value, std::size_t count>
Value named(const std::array<std::pair<std::string_view, Value>, count>& values, const std::string& name,
            const std::string& argument) {
  std::string names;
  for (const auto& [known, value] : values) {
    if (known == name) return value;
    names.append(names.empty() ? "" : ", ").append(known);
  }
  throw InputError(argument + ": '" + name + "' is not one of " + names);
}

void check_names(const std::vector<fs::path>& scenes) {
  std::vector<NamedScene> named;
  for (const fs::path& scene : scenes) named.push_back({scene, scene_name(scene)});
  check_scene_names(named);
}

std::string identity(const py::object& config, const py::object& overrides, const py::object& components) {
  return run_identity(load_config(config, override_texts(overrides), registered(components)));
}

}  // namespace

ReadOptions read_options(const Reading& reading) {
  ReadOptions options;
  if (reading.camera) options.camera = CameraFile(*reading.camera);
  if (reading.depth_scale && !(*reading.depth_scale >= 1e-9 && *reading.depth_scale <= 1e4))
    throw InputError("depth_scale: must be from 1e-9 to 1e4 metres per unit");
  options.depth_scale = reading.depth_scale;
  if (reading.depth_kind) options.depth_kind = named(depth_kinds, *reading.depth_kind, "depth_kind");
  if (reading.labels) options.labels = named(label_schemes, *reading.labels, "labels");
  return options;
}

py::object config_for_all(const py::object& config, const std::vector<std::string>& overrides,
                          const std::vector<fs::path>& scenes, const ReadOptions& options, const Arena& arena) {
  if (!config.is_none() || !depth_only_may_replace({}, overrides)) return config;
  if (!arena.run([&] { return none_has_colour(scenes, options); })) return config;
  warn(std::string("no scene has a colour image; depth alone is used, with depth_only.yaml") + config_of_depth);
  return py::cast(depth_only_config());
}

LoadedConfig load_config(const py::object& config, const std::vector<std::string>& overrides,
                         const py::dict& components) {
  if (!config.is_none() && !py::isinstance<py::str>(config) && !py::hasattr(config, "__fspath__"))
    throw ConfigError(
        "config: expected a file, the name of an installed config, or None; single values go into overrides");
  ConfigTree tree(config.is_none() ? default_config() : path_of(config), overrides);
  Registry registry(plugin_search_path(tree.plugin_directories()));
  const py::object base = py::module_::import("gestalt.components").attr("Component");
  for (const auto& [name, type] : components) {
    if (!py::isinstance<py::str>(name) || !PyType_Check(type.ptr()) || PyObject_IsSubclass(type.ptr(), base.ptr()) != 1)
      throw py::type_error("components: " + py::cast<std::string>(py::repr(name)) +
                           ": expected a name with a class derived from gestalt.Relation, Classifier or Solver");
    add_component(registry, py::cast<std::string>(name), py::reinterpret_borrow<py::object>(type));
  }
  return {std::move(tree), std::move(registry)};
}

std::vector<fs::path> paths(const py::object& paths) {
  if (py::isinstance<py::str>(paths) || py::isinstance<py::bytes>(paths) || py::hasattr(paths, "__fspath__"))
    return {path_of(paths)};
  std::vector<fs::path> all;
  for (const py::handle path : paths) all.push_back(path_of(path));
  return all;
}

std::vector<fs::path> some_paths(const py::object& given) {
  std::vector<fs::path> some = paths(given);
  if (some.empty()) throw InputError("scenes: the list is empty; give a folder of scenes, or a list of them");
  return some;
}

void bind_segmenter(py::module_& module) {
  py::class_<Result>(
      module, "Result",
      "The result of a frame. Patches are numbered from 0, segments by their labels. A pickled result becomes a "
      "gestalt.StoredResult with the same attributes.")
      .def_property_readonly("name", on_object(&Result::name), "The name of the frame.")
      .def_property_readonly("labels", on_object(&Result::labels),
                             "(height, width) uint16: the segment of each pixel, background included; 0 in none.")
      .def_property_readonly("object_labels", on_object(&Result::objects_image),
                             "(height, width) uint16: labels with the background at 0.")
      .def_property_readonly("patch_labels", on_object(&Result::patch_labels),
                             "(height, width) int32: 1 + the number of each pixel's patch; 0 in none.")
      .def_property_readonly("normals", on_object(&Result::normals),
                             "(height, width, 3) float32, unit, towards the camera; 0 where there is none.")
      .def_property_readonly("points", on_object(&Result::points),
                             "(height, width, 3) float32, metres in the camera frame (x right, y down, z forward); "
                             "(0, 0, 0) where there is no depth.")
      .def_property_readonly("segments", py::cpp_function(on_object(&Result::segments), Computing()),
                             "Label, role, pixels and patches of each segment, as in result.json, largest first.")
      .def_property_readonly("objects", py::cpp_function(on_object(&Result::objects), Computing()),
                             "The segments that are objects, each a gestalt.Object, largest first.")
      .def_property_readonly("patches", py::cpp_function(on_object(&Result::patches), Computing()),
                             "Pixels and parametric surface of each patch, as in result.json.")
      .def_property_readonly(
          "structural", [](Self<Result> self) { return self.object.pairs(Level::structural); },
          R"(Pairs of neighbouring patches, a dictionary. names: the k relation values; pairs: (n, 2) patches; values: (n, k);
probabilities: (n,) that both patches belong to one object, NaN where not classified.)")
      .def_property_readonly(
          "assembly", [](Self<Result> self) { return self.object.pairs(Level::assembly); },
          "The same for pairs that are not neighbours; no rows if the config has no assembly level.")
      .def_property_readonly("milliseconds", on_object(&Result::milliseconds), "Time spent in each level.")
      .def("to_dict", on_object(&Result::dictionary), Computing(), "The content of result.json.")
      .def("save", on_object(&Result::save), Computing(), py::arg("folder"), py::arg("name") = py::none(),
           "Writes labels.png, objects.png, overlay.png, patches.png and result.json, all or none.\n\n"
           "name: a folder below it to write to instead. The name may be untrusted: no link is followed there.")
      .def("__reduce__", on_object(&Result::reduced), Computing())
      .def("__repr__", on_object(&Result::text));

  py::class_<PySegmenter>(module, "Segmenter", R"(The segmenter, ready to run; may be used from many threads.

config: a YAML file or the name of an installed config; None: default.yaml, or, with a warning, depth_only.yaml
and its model for frames without colour, unless overrides set a model, relation or classifier.
overrides: a list of strings like "structural.minimum_size=50", as for --set of the command, or a dictionary like
{"structural.minimum_size": 50}.
components: Python classes by name; None: the registered ones.
threads: number of TBB threads, 0 for all. Results are the same for any number.

Raises ConfigError, PluginError, ModelError. Warns when the model was trained with other parameters.)")
      .def(py::init([](const py::object& config, const py::object& overrides, const py::object& components,
                       int threads) {
             return std::make_unique<PySegmenter>(config, override_texts(overrides), registered(components), threads);
           }),
           py::arg("config") = py::none(), py::arg("overrides") = py::tuple(), py::kw_only(), Computing(),
           py::arg("components") = py::none(), py::arg("threads") = 0)
      .def("__call__", on_object(&PySegmenter::call), Computing(), py::arg("colour"), py::arg("depth") = py::none(),
           py::arg("camera") = py::none(), py::arg("name") = "frame", py::kw_only(),
           py::arg("depth_scale") = py::none(), py::arg("depth_kind") = py::none(), R"(Segments a frame.

colour: (height, width, 3) uint8, red green blue; or None.
depth: (height, width) uint16 in millimetres or float in metres; 0 or not finite where there is none.
depth_scale: metres per unit of depth, if depth is in another unit.
depth_kind: "plain", along the optical axis, which is the default; "radial", the distance from the camera; "rotated", 16
bits rotated by three as in SUN RGB-D.

camera: a gestalt.Camera, or a dictionary with width, height, fx, fy, cx and cy, in pixels.

The interpreter lock is released during the call. Raises InputError if the images and the camera do not match,
PluginError if a component fails.)")
      .def("segment", on_object(&PySegmenter::read), Computing(), py::arg("scene"), py::arg("camera") = py::none(),
           py::kw_only(), py::arg("depth_scale") = py::none(), py::arg("depth_kind") = py::none(),
           py::arg("labels") = py::none(),
           "Segments a scene folder or a cloud, as `gestalt segment` does; camera replaces the scene's, depth_scale "
           "(metres per unit) its unit; depth_kind and labels are as --depth-kind and --labels.")
      .def(
          "evaluate", on_object(&PySegmenter::evaluate), Computing(), py::arg("scenes"), py::kw_only(),
          py::arg("depth_scale") = py::none(), py::arg("depth_kind") = py::none(), py::arg("labels") = py::none(),
          R"(Scores of scenes with ground truth by category (of several sets SET/CATEGORY), their "mean", and of "all", as
`gestalt evaluate --json` prints them.

labels: the meaning of ground truth, "osd", "objects" or "colours"; None: inferred if unambiguous.

Warns about improbable input. Also raises InputError if no scene has an object, and for a scene without colour among
scenes with colour.)")
      .def_property_readonly("config", on_object(&PySegmenter::config), "The resolved config as a dictionary.")
      .def("__repr__", on_object(&PySegmenter::text));

  py::class_<PyTracker>(module, "Tracker", R"(Gives objects numbers that they keep from frame to frame.

keep: frames for which the number of an object that is not seen is kept.)")
      .def(py::init<int>(), py::kw_only(), py::arg("keep") = TrackerParams().keep)
      .def("update", on_object(&PyTracker::update), py::arg("result"), py::arg("pose") = py::none(),
           R"(The next frame's objects, of a gestalt.Result; call it in the order of the frames, from one thread.

pose: (4, 4), from the camera's frame to one that does not move, metres; None: the camera stands still.

A dictionary: numbers, the number of each object by its label; new, the numbers that are given for the first time;
hidden, those of objects that are not seen but kept; lost, those that are not kept from this frame on; split, pairs of
a whole and the new part of it; merged, pairs of a part and the whole that it is in now. Raises InputError for a pose
that is not a rigid motion.)");

  module.def("read_scene", &read, Computing(), py::arg("scene"), py::arg("camera") = py::none(), py::kw_only(),
             py::arg("depth_scale") = py::none(), py::arg("depth_kind") = py::none(), py::arg("labels") = py::none());
  module.def(
      "override_texts",
      [](const py::object& overrides) {
        py::list texts;
        for (const std::string& text : override_texts(overrides)) texts.append(text_of(text));
        return texts;
      },
      py::arg("overrides"), "Overrides as a list of \"path=value\".");
  module.def("check_scene_names", &check_names, py::arg("scenes"),
             "Raises InputError unless the names of the scenes differ and can be names of folders.");
  module.def("run_identity", &identity, Computing(), py::arg("config") = py::none(), py::arg("overrides") = py::tuple(),
             py::kw_only(), py::arg("components") = py::none(),
             "A digest of the content of a segmenter: config, model, plugins, this build.");
}

}  // namespace gestalt::python
