// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gestalt/core/scene/scene.h"

namespace gestalt {

/// Name and range of one value that a relation gives.
struct RelationValue {
  std::string name;  ///< the paper's name, e.g. "r_co"; unique within a config
  double low;        ///< the value lies in [low, high]; infinite where it has no bound
  double high;
  std::string text;  ///< one line: what it measures, its unit, its value for degenerate patches
};

/// Two surfaces whose relation is asked for. border is null when they do not touch in the image.
struct SurfacePair {
  int a;
  int b;
  const Adjacency* border;
};

/// A relation bound to one scene: descriptors of all patches are there, a pair is cheap.
class GESTALT_EXPORT Measure {
 public:
  virtual ~Measure();

  /// Writes the relation's values for the pair, in declared order. Const, thread-safe, symmetric in a and b, and
  /// finite and in the declared range for any two non-empty surfaces.
  virtual void operator()(const SurfacePair& pair, std::span<double> values) const = 0;

  /// The values of many pairs, row-major: by default one pair after the other. To override where many are cheaper at
  /// once, as for a relation in another language. A frame's pairs may come in several calls at a time.
  virtual void measure(std::span<const SurfacePair> pairs, std::span<double> values) const;
};

/// Structural and assembly level (Eq. 9 and 11): a Gestalt relation between two surfaces. Its observe(), where it has
/// one, is the part of bind() that needs no surfaces.
class GESTALT_EXPORT Relation : public Observer {
 public:
  ~Relation() override;

  virtual const std::vector<RelationValue>& values() const = 0;

  /// True when observe() or bind() reads the colour image.
  virtual bool needs_colour() const { return false; }

  /// True when the values mean something only for surfaces that touch in the image.
  virtual bool needs_border() const { return false; }

  /// Computes the descriptors of every surface. The scene outlives the measure. Const and thread-safe.
  virtual std::unique_ptr<Measure> bind(const Scene& scene) const = 0;
};

}  // namespace gestalt
