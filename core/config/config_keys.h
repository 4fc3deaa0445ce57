// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "config_draft.h"
#include "gestalt/core/config/figure_ground_params.h"
#include "gestalt/core/config/sensor_params.h"
#include "gestalt/core/config/surface_modelling_params.h"
#include "gestalt/core/scene/graph.h"

namespace gestalt::config {

inline constexpr const char* both_levels = "structural+assembly";

Parameter levels_declaration();
Parameter time_budget_declaration();
Parameter on_timeout_declaration();
Parameter working_resolution_declaration();
Parameter minimum_size_declaration(Level level);
Parameter negatives_declaration();

/// The keys of a config, with what stands there, where a draft keeps it and what it means. What reads a config and what
/// writes its schema both go over these: make has a function for each type of value, which gives a key of its own kind.
template <class Make>
auto config_keys(Make& make, Draft& draft) {
  const auto level = [&make](Level which, const char* text, LevelDraft& into) {
    return make.section(
        name_of(which), text,
        {make.list("relations", "relation", "Relations of a pair of patches, in the order of a model's values",
                   into.relations),
         make.component("classifier", "classifier", "Turns a pair's values into p(same object)", into.classifier),
         make.value(minimum_size_declaration(which), into.minimum_size),
         make.value(negatives_declaration(), into.negatives)});
  };
  return std::vector{
      make.version("schema_version", "Version of this file's keys: 1"),
      make.base("extends", "Another config, relative to this file, else an installed one; this one is merged over it"),
      make.directories("plugin_directories",
                       "Searched for plugins before GESTALT_PLUGIN_PATH and the installation, relative to this file",
                       draft.plugin_directories),
      make.value(levels_declaration(), draft.levels),
      make.value(time_budget_declaration(), draft.time_budget),
      make.value(on_timeout_declaration(), draft.on_timeout),
      make.file("model", "Trained model: beside this file, else among the installed ones; none: no model", draft.model),
      make.settings("sensor", "The depth camera's noise", SensorParams::parameters().declarations(), draft.sensor),
      make.section("signal", "Signal level: pixels to patches",
                   {make.component("clusterer", "clusterer", "Makes planar patches of pixels", draft.clusterer),
                    make.value(working_resolution_declaration(), draft.working_resolution)}),
      make.section(
          "primitive", "Primitive level: patches to surfaces",
          {make.list("fitters", "fitter", "Surface models of a patch; the first must fit any patch", draft.fitters),
           make.settings("model_selection", "Choice of models and merging of surfaces",
                         SurfaceModellingParams::parameters().declarations(), draft.model_selection)}),
      level(Level::structural, "Structural level: pairs of patches that touch", draft.structural),
      level(Level::assembly, "Assembly level: pairs of patches that do not touch", draft.assembly),
      make.section("decision", "Global decision: the graph of probabilities to objects",
                   {make.component("solver", "solver", "Cuts the graph into objects", draft.solver),
                    make.settings("figure_ground", "Separation of objects from background",
                                  FigureGroundParams::parameters().declarations(), draft.figure_ground)})};
}

}  // namespace gestalt::config
