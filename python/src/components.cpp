// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "components.h"

#include <pybind11/stl.h>

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "arrays.h"
#include "core_call.h"
#include "gestalt/core/base/error.h"
#include "on_object.h"

namespace gestalt::python {

namespace {

/// A Python object that may be let go on any thread.
using Owned = std::shared_ptr<py::object>;

Owned owned(py::object object) {
  return {new py::object(std::move(object)), [](py::object* last) {
            if (interpreter_is_ending() || !Py_IsInitialized()) return;  // the object goes with the interpreter
            const py::gil_scoped_acquire gil;
            delete last;
          }};
}

/// f() with the interpreter held; what Python raises becomes the core's error E, after whose component it is. A
/// KeyboardInterrupt comes out of the call as such all the same.
template <class E, class F>
auto calling_python(const std::string& component, F f) {
  return hold_interpreter([&] {
    try {
      return f();
    } catch (const py::error_already_set& error) {
      if (error.matches(PyExc_KeyboardInterrupt)) note_interruption(error);
      throw E(component + ": " + error.what());
    } catch (const py::cast_error& error) {
      throw E(component + ": " + error.what());
    }
  });
}

py::array_t<double> matrix(std::span<const double> values, std::size_t rows) {
  py::array_t<double> array({rows, rows ? values.size() / rows : 0});
  std::copy(values.begin(), values.end(), array.mutable_data());
  return array;
}

/// Writes what a component gave for a number of rows; one column may come without its axis.
void read_rows(const py::object& given, std::size_t rows, const std::string& who, std::span<double> values) {
  if (py::hasattr(given, "mask") && py::hasattr(given, "filled")) throw PluginError(who + " returned a masked array");
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!array) {
    PyErr_Clear();
    throw PluginError(who + " did not return an array of numbers");
  }
  const std::size_t columns = values.size() / rows;
  const bool flat = columns == 1 && array.ndim() == 1 && std::size_t(array.shape(0)) == rows;
  if (!flat && (array.ndim() != 2 || std::size_t(array.shape(0)) != rows || std::size_t(array.shape(1)) != columns)) {
    std::string shape;
    for (py::ssize_t i = 0; i < array.ndim(); ++i) shape += (i ? ", " : "") + std::to_string(array.shape(i));
    throw PluginError(who + " returned an array of shape (" + shape + "), expected (" + std::to_string(rows) + ", " +
                      std::to_string(columns) + ")");
  }
  std::copy_n(array.data(), values.size(), values.begin());
}

// ---------------------------------------------------------------------------------------------------- parameters

/// A gestalt.Parameter; its type is that of its default.
Parameter declaration(const std::string& name, const py::handle& parameter) {
  Parameter declared;
  declared.name = name;
  const py::object value = parameter.attr("default");
  declared.unit = py::cast<std::string>(parameter.attr("unit"));
  declared.text = py::cast<std::string>(parameter.attr("text"));
  if (py::isinstance<py::bool_>(value)) {
    declared.type = Parameter::Type::boolean;
    declared.default_value = py::cast<bool>(value);
    declared.minimum = 0, declared.maximum = 1;
    return declared;
  }
  if (py::isinstance<py::str>(value)) {
    declared.type = Parameter::Type::choice;
    declared.default_value = py::cast<std::string>(value);
    declared.choices = py::cast<std::vector<std::string>>(parameter.attr("choices"));
    return declared;
  }
  declared.minimum = py::cast<double>(parameter.attr("low"));
  declared.maximum = py::cast<double>(parameter.attr("high"));
  if (py::isinstance<py::int_>(value)) {
    declared.type = Parameter::Type::integer;
    declared.default_value = py::cast<std::int64_t>(value);
  } else {
    declared.type = Parameter::Type::real;
    declared.default_value = py::cast<double>(value);
  }
  return declared;
}

std::vector<Parameter> declarations(const py::object& type) {
  std::vector<Parameter> all;
  for (const auto& [name, parameter] : py::cast<py::dict>(type.attr("parameters")))
    all.push_back(declaration(py::cast<std::string>(name), parameter));
  return all;
}

/// An object of the class with the parameters as keyword arguments.
py::object make(const py::object& type, const std::vector<Parameter>& declared, const ParameterValues& given) {
  py::dict arguments;
  for (const auto& [name, value] : complete(declared, given))
    arguments[py::str(name)] = std::visit([](const auto& v) -> py::object { return py::cast(v); }, value);
  return type(**arguments);
}

// ---------------------------------------------------------------------------------------------------- relations

/// What a relation sees of a frame. Images are views that may be kept; everything else ends with the frame.
class SceneView {
 public:
  explicit SceneView(const Scene& scene)
      : frame_(scene.frame()),
        normals_(scene.patches().normals),
        labels_(scene.surfaces().labels),
        surfaces_(&scene.surfaces()) {}

  py::object colour() const { return colour_array(frame_.colour); }
  py::array depth() const { return array_of(frame_.depth); }
  py::array points() const { return array_of(frame_.points); }
  py::array normals() const { return array_of(normals_); }
  py::array labels() const { return array_of(labels_); }
  Camera camera() const { return frame_.camera; }
  std::size_t count() const { return surfaces().surfaces.size(); }

  py::array_t<std::int64_t> sizes() const {
    py::array_t<std::int64_t> sizes{py::ssize_t(count())};
    for (std::size_t i = 0; i < count(); ++i) sizes.mutable_at(i) = std::int64_t(surfaces().surfaces[i].pixels.size());
    return sizes;
  }

  py::array_t<std::int64_t> neighbours() const {
    const std::vector<Adjacency>& all = surfaces().adjacencies;
    py::array_t<std::int64_t> pairs({all.size(), std::size_t{2}});
    for (std::size_t i = 0; i < all.size(); ++i) pairs.mutable_at(i, 0) = all[i].a, pairs.mutable_at(i, 1) = all[i].b;
    return pairs;
  }

  py::array_t<std::int64_t> border(int a, int b, bool close) const {
    const bool swapped = a > b;
    if (swapped) std::swap(a, b);
    for (const Adjacency& adjacency : surfaces().adjacencies)
      if (adjacency.a == a && adjacency.b == b)
        return pixels(close ? adjacency.border_3d : adjacency.border_2d, swapped);
    return pixels({}, false);
  }

  py::object surface(int index) const {
    if (index < 0 || std::size_t(index) >= count())
      throw py::index_error("there is no surface " + std::to_string(index));
    return object_of(surfaces().surfaces[std::size_t(index)].model->to_json());
  }

  /// The frame is over.
  void close() { surfaces_ = nullptr; }

 private:
  static py::array_t<std::int64_t> pixels(const std::vector<PixelPair>& border, bool swapped) {
    py::array_t<std::int64_t> rows({border.size(), std::size_t{2}});
    for (std::size_t i = 0; i < border.size(); ++i) {
      rows.mutable_at(i, swapped ? 1 : 0) = border[i].a;
      rows.mutable_at(i, swapped ? 0 : 1) = border[i].b;
    }
    return rows;
  }

  const SurfaceSet& surfaces() const {
    if (!surfaces_)
      throw std::runtime_error("the frame of this scene has ended; compute in bind() whatever is needed later");
    return *surfaces_;
  }

  Frame frame_;
  cv::Mat normals_, labels_;
  const SurfaceSet* surfaces_;
};

class PythonMeasure final : public Measure {
 public:
  PythonMeasure(std::string who, std::shared_ptr<SceneView> view, Owned measure)
      : who_(std::move(who)), view_(std::move(view)), measure_(std::move(measure)) {}
  ~PythonMeasure() override { view_->close(); }

  void operator()(const SurfacePair& pair, std::span<double> values) const override { measure({&pair, 1}, values); }

  void measure(std::span<const SurfacePair> pairs, std::span<double> values) const override {
    if (pairs.empty()) return;
    calling_python<PluginError>(who_, [&] {
      py::array_t<std::int64_t> numbers({pairs.size(), std::size_t{2}});
      for (std::size_t i = 0; i < pairs.size(); ++i)
        numbers.mutable_at(i, 0) = pairs[i].a, numbers.mutable_at(i, 1) = pairs[i].b;
      read_rows(call_python(*measure_, numbers), pairs.size(), who_, values);
    });
  }

 private:
  std::string who_;
  std::shared_ptr<SceneView> view_;
  Owned measure_;
};

class PythonRelation final : public Relation {
 public:
  PythonRelation(std::string who, const py::object& object) : who_(std::move(who)), object_(owned(object)) {
    for (const py::handle value : object.attr("values"))
      values_.push_back({py::cast<std::string>(value.attr("name")), py::cast<double>(value.attr("low")),
                         py::cast<double>(value.attr("high")), py::cast<std::string>(value.attr("text"))});
    if (values_.empty()) throw PluginError(who_ + " declares no values");
    needs_colour_ = py::cast<bool>(object.attr("needs_colour"));
    needs_border_ = py::cast<bool>(object.attr("needs_border"));
  }

  const std::vector<RelationValue>& values() const override { return values_; }
  bool needs_colour() const override { return needs_colour_; }
  bool needs_border() const override { return needs_border_; }
  std::unique_ptr<Measure> bind(const Scene& scene) const override {
    return calling_python<PluginError>(who_, [&] {
      const auto view = std::make_shared<SceneView>(scene);
      return std::make_unique<PythonMeasure>(who_, view, owned(call_python(object_->attr("bind"), view)));
    });
  }

 private:
  std::string who_;
  Owned object_;
  std::vector<RelationValue> values_;
  bool needs_colour_ = false, needs_border_ = false;
};

// ---------------------------------------------------------------------------------------------------- classifiers

class PythonPredictor final : public Predictor {
 public:
  PythonPredictor(std::string who, nlohmann::json state, Owned predict)
      : who_(std::move(who)), state_(std::move(state)), predict_(std::move(predict)) {}

  double probability(std::span<const double> values) const override {
    double p = 0;
    probabilities(values, {&p, 1});
    return p;
  }

  void probabilities(std::span<const double> values, std::span<double> p) const override {
    if (p.empty()) return;
    calling_python<PluginError>(
        who_, [&] { read_rows(call_python(*predict_, matrix(values, p.size())), p.size(), who_, p); });
    for (const double one : p)
      if (!(one >= 0 && one <= 1))
        throw PluginError(who_ + " returned the probability " + std::to_string(one) + ", which is not in [0, 1]");
  }

  nlohmann::json state() const override { return state_; }

 private:
  std::string who_;
  nlohmann::json state_;
  Owned predict_;
};

class PythonClassifier final : public Classifier {
 public:
  PythonClassifier(std::string who, const py::object& object) : who_(std::move(who)), object_(owned(object)) {}

  std::unique_ptr<Predictor> train(const Samples& samples) const override {
    require_both_classes(samples);
    const nlohmann::json state = calling_python<PluginError>(who_, [&] {
      py::array_t<bool> positive{py::ssize_t(samples.rows())};
      for (std::size_t i = 0; i < samples.rows(); ++i) positive.mutable_at(i) = samples.positive[i] != 0;
      return json_of(call_python(object_->attr("train"), matrix(samples.values, samples.rows()), positive));
    });
    return restore(state, samples.columns);
  }

  std::unique_ptr<Predictor> restore(const nlohmann::json& state, std::size_t columns) const override {
    return calling_python<ModelError>(who_, [&] {
      return std::make_unique<PythonPredictor>(who_, state,
                                               owned(call_python(object_->attr("restore"), object_of(state), columns)));
    });
  }

 private:
  std::string who_;
  Owned object_;
};

// ---------------------------------------------------------------------------------------------------- solvers

class PythonSolver final : public Solver {
 public:
  PythonSolver(std::string who, const py::object& object)
      : who_(std::move(who)), object_(owned(object)), takes_all_pairs_(object.attr("takes_all_pairs").cast<bool>()) {}

  bool takes_all_pairs() const override { return takes_all_pairs_; }

  std::vector<int> solve(const Graph& graph) const override {
    return calling_python<PluginError>(who_, [&] {
      const std::size_t edges = graph.edges.size(), nodes = graph.sizes.size();
      py::array_t<std::int64_t> sizes{py::ssize_t(nodes)}, pairs({edges, std::size_t{2}});
      py::array_t<double> p{py::ssize_t(edges)};
      py::array_t<bool> assembly{py::ssize_t(edges)};
      std::copy(graph.sizes.begin(), graph.sizes.end(), sizes.mutable_data());
      for (std::size_t i = 0; i < edges; ++i) {
        pairs.mutable_at(i, 0) = graph.edges[i].a, pairs.mutable_at(i, 1) = graph.edges[i].b;
        p.mutable_at(i) = graph.edges[i].probability;
        assembly.mutable_at(i) = graph.edges[i].level == Level::assembly;
      }
      if (nodes == 0) return std::vector<int>{};
      std::vector<double> groups(nodes);
      read_rows(call_python(object_->attr("solve"), sizes, pairs, p, assembly), nodes, who_, groups);
      std::map<double, int> number;  // in order of first appearance
      std::vector<int> numbered;
      for (const double group : groups) {
        if (std::isnan(group)) throw PluginError(who_ + " returned a group that is not a number");
        numbered.push_back(number.try_emplace(group, int(number.size())).first->second);
      }
      return numbered;
    });
  }

 private:
  std::string who_;
  Owned object_;
  bool takes_all_pairs_;
};

template <class Kind, class Component>
void add(Registry& registry, const std::string& name, const py::object& type) {
  const std::string who = std::string(kind_name<Kind>) + " '" + name + "', written in Python";
  std::vector<Parameter> declared;
  ComponentInfo info;
  calling_python<PluginError>(who, [&] {
    declared = declarations(type);
    info = {"", name, py::cast<std::string>(type.attr("version")), py::cast<std::string>(type.attr("description")()),
            py::cast<std::string>(type.attr("__module__")) + "." + py::cast<std::string>(type.attr("__qualname__")) +
                " (Python)"};
  });
  const auto shared = owned(type);
  registry.add<Kind>(info, Factory<Kind>{declared, [who, shared, declared](const ParameterValues& given) {
                                           return calling_python<PluginError>(who, [&]() -> std::unique_ptr<Kind> {
                                             return std::make_unique<Component>(who, make(*shared, declared, given));
                                           });
                                         }});
}

}  // namespace

void add_component(Registry& registry, const std::string& name, const py::object& type) {
  const std::string kind = py::cast<std::string>(type.attr("kind"));
  if (kind == kind_name<Relation>) return add<Relation, PythonRelation>(registry, name, type);
  if (kind == kind_name<Classifier>) return add<Classifier, PythonClassifier>(registry, name, type);
  return add<Solver, PythonSolver>(registry, name, type);
}

void require_new_name(const std::string& kind, const std::string& name) {
  const Registry registry(plugin_search_path({}));
  if (const ComponentInfo* const other = registry.find(kind, name))
    throw py::value_error("'" + name + "' is already the name of a " + kind + ", in " + other->library.string() +
                          "; choose another name");
}

py::dict registered(const py::object& components) {
  return components.is_none() ? py::module_::import("gestalt.components").attr("registered") : components;
}

void bind_scene_view(py::module_& module) {
  py::class_<SceneView, std::shared_ptr<SceneView>>(module, "SceneView", R"(What a relation sees of a frame.

Images are read-only views that may be kept. What is asked of the patches must be asked within bind().)")
      .def_property_readonly("colour", on_object(&SceneView::colour),
                             "(height, width, 3) uint8, red green blue; None without colour.")
      .def_property_readonly("depth", on_object(&SceneView::depth),
                             "(height, width) float32, metres; 0 where there is none.")
      .def_property_readonly("points", on_object(&SceneView::points),
                             "(height, width, 3) float32, metres in the camera frame.")
      .def_property_readonly("normals", on_object(&SceneView::normals),
                             "(height, width, 3) float32, unit, towards the camera; 0 where there is none.")
      .def_property_readonly("labels", on_object(&SceneView::labels),
                             "(height, width) int32: 0 in no patch, else 1 + the patch's number.")
      .def_property_readonly("camera", on_object(&SceneView::camera))
      .def_property_readonly("count", on_object(&SceneView::count), "Number of patches.")
      .def_property_readonly("sizes", on_object(&SceneView::sizes), "(count,) pixels of each patch.")
      .def_property_readonly("neighbours", on_object(&SceneView::neighbours),
                             "(n, 2) patches that touch in the image, a < b.")
      .def("border", on_object(&SceneView::border), py::arg("a"), py::arg("b"), py::arg("close") = true,
           R"((n, 2) flat pixel indices of patch a and patch b that touch; close: only those near in depth.)")
      .def("surface", on_object(&SceneView::surface), py::arg("patch"), "The patch's surface as result.json has it.");
  module.def("require_new_name", &require_new_name, py::arg("kind"), py::arg("name"),
             "Raises ValueError if an installed component has that kind and name.");
}

}  // namespace gestalt::python
