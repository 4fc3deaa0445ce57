// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gestalt/core/plugin/relation.h"
#include "gestalt/core/scene/role.h"

namespace gestalt {

/// Relation values of pairs of surfaces: one row a pair, one column a named value.
struct RelationTable {
  struct Pair {
    int a;  ///< a < b
    int b;
  };
  std::vector<std::string> names;  ///< columns, in the order of the config
  std::vector<Pair> pairs;         ///< rows, sorted by (a, b)
  std::vector<double> values;      ///< row-major

  std::span<const double> row(std::size_t i) const { return {values.data() + i * names.size(), names.size()}; }
};

/// A relation with the name under which the config uses it.
struct NamedRelation {
  std::string name;
  std::shared_ptr<const Relation> relation;
  std::string plugin = name;          ///< its plugin's name, where the config gives the component another
  std::vector<std::string> values{};  ///< ComponentConfig::values
};

/// What a level calls a value of a relation: "r_ga", and "r_ga.coarse" of a relation that the config names coarse.
GESTALT_EXPORT std::string value_name(const std::string& value, const std::string& relation, const std::string& plugin);

/// The names of the values that a level has of the relations, in order. Throws ConfigError when two are the same.
GESTALT_EXPORT std::vector<std::string> value_names(const std::vector<NamedRelation>& relations);

/// Whether a surface has so many pixels: smaller ones have no relations.
GESTALT_EXPORT bool large_enough(const SurfaceSet& surfaces, int surface, double minimum_size);

/// Structural level: the pairs of 3D neighbours of which both have at least minimum_size pixels, sorted by (a, b).
GESTALT_EXPORT std::vector<SurfacePair> neighbour_pairs(const SurfaceSet& surfaces, double minimum_size);

/// Pairs of the assembly level, at most; all those of 632 surfaces are fewer. Their number grows by the square, and
/// with it time, memory and result.json.
constexpr std::size_t most_assembly_pairs = 200'000;

/// Surfaces that they are made of, at most, where there are more pairs than that.
constexpr std::size_t most_paired_surfaces = 4000;

/// Assembly level: all other pairs of surfaces of which both have at least minimum_size pixels, sorted by (a, b). Their
/// border is null unless they touch in the image.
/// Where that would be more than most_assembly_pairs: of the most_paired_surfaces largest (the first of equal ones)
/// each with those that are nearest to it, by their mean pixels, for one half, and the largest ones with each other for
/// the other half.
/// Where the surfaces' roles are given, only pairs of two objects.
GESTALT_EXPORT std::vector<SurfacePair> non_neighbour_pairs(const SurfaceSet& surfaces, double minimum_size,
                                                            std::span<const Role> roles = {});

/// How many pairs it has left out because there would be more than most_assembly_pairs.
GESTALT_EXPORT std::size_t omitted_pairs(const SurfaceSet& surfaces, double minimum_size,
                                         std::span<const Role> roles = {});

/// Relations bound to one scene, each once for whatever level asks for it.
class GESTALT_EXPORT Measures {
 public:
  /// Binds the relations in parallel. The scene outlives this.
  Measures(const Scene& scene, const std::vector<NamedRelation>& relations);

  /// That of the scene's frame.
  const Deadline& deadline() const { return deadline_; }

  const Measure& of(const Relation& relation) const { return *measures_.at(&relation); }

 private:
  Deadline deadline_;
  std::map<const Relation*, std::unique_ptr<Measure>> measures_;
};

/// The values of all relations for the pairs; measures must know them. Throws PluginError naming the relation when a
/// value is not finite or out of its declared range, TimeError when the frame's time is over.
GESTALT_EXPORT RelationTable relate(const std::vector<SurfacePair>& pairs, const std::vector<NamedRelation>& relations,
                                    const Measures& measures);

}  // namespace gestalt
