// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gestalt/core/config/config.h"
#include "gestalt/core/config/sensor_params.h"
#include "gestalt/core/pipeline/figure_ground.h"
#include "gestalt/core/pipeline/model.h"
#include "gestalt/core/pipeline/relation_table.h"
#include "gestalt/core/pipeline/surface_modelling.h"
#include "gestalt/core/scene/frame.h"
#include "gestalt/core/scene/patch_map.h"
#include "gestalt/core/scene/scene.h"
#include "gestalt/core/scene/segmentation.h"
#include "gestalt/core/scene/surface_set.h"

namespace gestalt {

/// Milliseconds of each level for one frame.
struct LevelTimes {
  double signal = 0;
  double primitive = 0;
  double structural = 0;  ///< roles, what is bound to the scene for either level, relations and classification
  double assembly = 0;    ///< relations and classification
  double decision = 0;

  double total() const { return signal + primitive + structural + assembly + decision; }
};

/// Everything that is computed of a frame before a trained model is needed.
struct Percept {
  std::shared_ptr<const Scene> scene;  ///< the frame, with the sensor's noise, and its patches and surfaces; never null
  std::vector<Role> roles;             ///< of each surface
  std::vector<double> sizes;           ///< of each surface, by find_sizes(); a segment of less than 1 is background
  RelationTable structural;            ///< 3D neighbours
  RelationTable assembly;              ///< all other pairs; empty without the assembly level
  std::size_t omitted_pairs = 0;       ///< that the assembly level leaves out of too many
  double pixel_density = 1;            ///< of the frame's camera: by what the levels' minimum sizes were multiplied
  std::optional<Level> left_out;       ///< the first level without relations, as the time was over (on_timeout: coarse)
  bool separate = true;  ///< FigureGroundParams::separate: pairs of an object and the background are not decided
  LevelTimes times;

  const Frame& frame() const { return scene->frame(); }
  const PatchMap& patches() const { return scene->patches(); }
  const SurfaceSet& surfaces() const { return scene->surfaces(); }
  const RelationTable& table(Level level) const { return level == Level::structural ? structural : assembly; }

  /// The relation values of an edge of the graph that the percept was decided to.
  std::span<const double> values(const Edge& edge) const { return table(edge.level).row(edge.row); }
};

/// The rows of the assembly table that the decision looks at: pairs of different structural groups. Where figure and
/// ground are separate, neither is of the background: what lies beyond an object may be seen on both of its sides, so
/// that the background is not grouped here.
GESTALT_EXPORT std::vector<std::size_t> assembly_rows(const Percept& percept,
                                                      const std::vector<int>& structural_groups);

/// The components of a config, ready to run. Immutable; every method may be called from many threads at
/// once, and gives the same result for any number of threads.
class GESTALT_EXPORT Pipeline {
 public:
  /// Makes the components; reads no model. Throws ConfigError, PluginError.
  Pipeline(Config config, const Registry& registry);

  const Config& config() const { return config_; }

  /// The sensor's, which perceive() takes frames to have.

  /// What a model of a level must be like. Throws ConfigError when the config lacks the level.
  ExpectedModel expected_model(Level level) const;

  /// Reads the config's model. Throws ModelError when the config names none, or it does not fit.
  Models load_models() const;

  /// Whether the models, which fit, were trained with other parameters of the levels below the classifiers.
  bool trained_otherwise(const Models& models) const;

  /// Signal and primitive level, and the relations of all levels. Frames of more pixels than the working resolution are
  /// perceived at a part of theirs; surfaces and patches are brought back to all of it, the tables are of the part.
  /// Throws InputError when a relation needs colour and the frame has none, TimeError when the frame's time budget is
  /// over; where late frames are coarse and there are surfaces, their relations are left out instead. A TBB group in
  /// which this is called does not cancel it.
  Percept perceive(const Frame& frame) const;

  /// Group of each surface by the structural level alone, numbered from 0; each surface is one where the solver takes
  /// all pairs of the assembly level. model must be as expected_model() says.
  std::vector<int> structural_groups(const Percept& percept, const Model& model) const;

  /// Classification of the pairs and the global decision. At the assembly level only pairs of different
  /// structural_groups() count. models must be as expected_model() says, as load_models() ensures. The time spent is
  /// added to times. Throws TimeError when it and that of perceive() exceed the time budget, unless late frames are
  /// coarse.
  Segmentation decide(const Percept& percept, const Models& models, LevelTimes* times = nullptr) const;

 private:
  Config config_;
  std::shared_ptr<const Clusterer> clusterer_;
  std::vector<std::shared_ptr<const Fitter>> fitters_;
  SurfaceModellingParams surface_modelling_;
  struct Grouping {
    std::vector<NamedRelation> relations;
    std::shared_ptr<const Classifier> classifier;
    std::vector<std::string> value_names;
    int minimum_size;
  };
  using Known = std::vector<std::pair<ComponentConfig, NamedRelation>>;
  static Grouping make_grouping(const LevelConfig& config, const Registry& registry, Known& known);

  SensorParams sensor_;
  std::vector<NamedRelation> relations_;  // of all levels, each once
  Grouping structural_;
  std::optional<Grouping> assembly_;
  std::shared_ptr<const Solver> solver_;
  FigureGroundParams figure_ground_;
  Percept perceive_uncancelled(const Frame& frame) const;
  template <class Work>
  void unless_late(Percept& percept, Level level, const Work& work) const;
  Graph structural_graph(const Percept& percept, const Model& model, const Deadline& deadline) const;
};

}  // namespace gestalt
