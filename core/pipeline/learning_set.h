// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "gestalt/core/pipeline/pipeline.h"
#include "gestalt/core/plugin/classifier.h"

namespace gestalt {

/// Ground truth of a pixel in a label image (OSD convention): 0 ignored, 1-9 background, 20-29 parts of the first
/// object, 30-39 of the second, ... Gives 0 ignored, 1 background, 2 and up an object.
inline int object_of_label(int label) { return label < 10 ? (label > 0 ? 1 : 0) : label / 10; }

/// Objects with at least one pixel.
GESTALT_EXPORT int count_objects(const cv::Mat_<std::uint16_t>& ground_truth);

/// Majority object over the pixels of every surface that have ground truth: 0 none, 1 background, >= 2 object.
/// Ties go to the smaller number.
GESTALT_EXPORT std::vector<int> surface_objects(const SurfaceSet& surfaces,
                                                const cv::Mat_<std::uint16_t>& ground_truth);

/// The labelled pairs of a table (paper, Section 5): positive when both surfaces belong to one object, negative when to
/// two, or to an object and background. Pairs of two background surfaces, or with a surface without ground truth, are
/// no samples. objects: of each surface, as surface_objects() gives them.
GESTALT_EXPORT Samples labelled_pairs(const RelationTable& table, const std::vector<int>& objects);

/// What learning keeps of a scene with ground truth.
struct LearningScene {
  std::string name;
  Percept percept;           ///< its scene without images, patches and borders
  std::vector<int> objects;  ///< of each surface
};

/// Throws InputError when the ground truth is of another size than the frame.
GESTALT_EXPORT LearningScene make_learning_scene(const Pipeline& pipeline, const Frame& frame,
                                                 const cv::Mat_<std::uint16_t>& ground_truth);

/// The samples of the assembly level: the labelled ones of the pairs that the decision looks at (paper, Section 6).
GESTALT_EXPORT Samples assembly_pairs(const LearningScene& scene, const std::vector<int>& structural_groups);

/// Trains the levels of the pipeline's config on scenes that it has perceived: first the structural level, then, on the
/// pairs that this leaves apart, the assembly level. Deterministic for equal scenes in equal order. Throws ModelError
/// when a level has no pairs of both classes. Columns may have been taken out of the tables, the same of all scenes:
/// the models are for what is left.
GESTALT_EXPORT Models learn(const Pipeline& pipeline, const std::vector<const LearningScene*>& scenes);

}  // namespace gestalt
