// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <opencv2/core.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "gestalt/core/base/export.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

// What is counted, and the definitions of all values: docs/evaluation.md.

/// What a region of the ground truth is: a whole object (label / 10), or each of its disjoint visible parts (label).
enum class RegionKind { objects, parts };

/// Which segments are taken for background and so left out of the overlap and boundary values: a label image does not
/// tell.
enum class BackgroundRule {
  table,     ///< the largest segment, if more than half of it lies on background
  largest,   ///< the largest segment, whatever it lies on
  majority,  ///< every segment of which more than half lies on background (uses the ground truth: optimistic)
  none       ///< no segment: for label images that hold objects only
};
inline constexpr std::array<std::string_view, 4> background_rule_names{"table", "largest", "majority", "none"};

/// Overlap and boundary values after the evaluation of UOIS (Xie et al.), each in [0, 1].
struct OverlapBoundary {
  double overlap_precision = 0;
  double overlap_recall = 0;
  double overlap_f = 0;
  double boundary_precision = 0;
  double boundary_recall = 0;
  double boundary_f = 0;
  double detected = 0;  ///< share of regions with a segment of overlap F > 0.75
};

/// How well parts are separated. Not a number when the ground truth holds no such part.
struct PartScore {
  double weighted_overlap = 0;    ///< best intersection over union of each part, weighted by its size
  double over_segmentation = 0;   ///< share of the parts' pixels outside their best segment
  double under_segmentation = 0;  ///< pixels of the best segments outside their parts, over the parts' pixels
};

/// Counts for precision and recall pooled over regions: a region's segment is the one that shares most pixels with it.
struct GESTALT_EXPORT PooledPixels {
  std::int64_t true_positive = 0;   ///< shared
  std::int64_t false_positive = 0;  ///< of the segment only
  std::int64_t region = 0;          ///< all of the regions

  double precision() const;  ///< 1 without any segment
  double recall() const;     ///< 1 without any region

  PooledPixels& operator+=(const PooledPixels& other);
};

/// One scene's score.
struct ImageScore {
  PooledPixels pooled;
  std::vector<PooledPixels> each;  ///< the counts of every region alone, by ascending label (paper, Fig. 5)
  std::int64_t regions = 0;
  std::int64_t segments = 0;
  std::array<OverlapBoundary, background_rule_names.size()> overlap_boundary;  ///< by BackgroundRule
  PartScore all_parts;                                                         ///< background parts included
  PartScore object_parts;
};

/// Scores a label image (0 = no segment). Only pixels with ground truth count; labels are those of learning_set.h.
/// Throws InputError when the sizes differ or the images are empty.
GESTALT_EXPORT ImageScore score_image(const cv::Mat_<std::uint16_t>& ground_truth,
                                      const cv::Mat_<std::uint16_t>& prediction, RegionKind kind = RegionKind::objects);

/// One row of the tables: images and regions are counts, precision and recall are of the pixels of all images, all else
/// are means over the images.
struct ScoreRow {
  std::string category;
  std::int64_t images = 0;
  std::int64_t regions = 0;
  double segments = 0;
  double precision = 0;
  double recall = 0;
  std::array<OverlapBoundary, background_rule_names.size()> overlap_boundary;
  PartScore all_parts;
  PartScore object_parts;
};

/// A row for each category, in order of first appearance, and last the row "all". categories[i] is that of scores[i];
/// an image of category "" counts in "all" only.
GESTALT_EXPORT std::vector<ScoreRow> summarise(const std::vector<ImageScore>& scores,
                                               const std::vector<std::string>& categories);

/// The same rows with a row "mean" before the last: the sums of the categories' counts and the means of their other
/// values, so that a category of many images counts no more than one of few. There is none of less than two categories.
GESTALT_EXPORT std::vector<ScoreRow> with_mean(std::vector<ScoreRow> rows);

/// The rows as aligned tables, all but counts in percent: the share of regions with F > 0.75, overlap F and boundary F
/// under one rule; P and R pooled.
GESTALT_EXPORT std::string format_tables(const std::vector<ScoreRow>& rows, RegionKind kind, BackgroundRule rule);

/// All else: overlap and boundary for each background rule, parts.
GESTALT_EXPORT std::string format_other_tables(const std::vector<ScoreRow>& rows, RegionKind kind);

/// What a rule does, for the reader of a table.
GESTALT_EXPORT std::string_view meaning(BackgroundRule rule);

/// The rows by category, every value as a fraction: {"boxes": {"images": 17, "P": 0.99, "table:oF": 0.95, ...}, ...}.
GESTALT_EXPORT nlohmann::ordered_json to_json(const std::vector<ScoreRow>& rows);

/// Reads a label image: a PNG of one channel of 8 or 16 bits. Throws InputError for any other file.
GESTALT_EXPORT cv::Mat_<std::uint16_t> read_label_image(const std::filesystem::path& file);

/// Category of each scene name, from a file with the columns scene and category. Empty when there is no such file.
/// Throws InputError, with the line, when it cannot be understood.
GESTALT_EXPORT std::map<std::string, std::string> read_categories(const std::filesystem::path& file);

/// The ground truth of a scene where it has depth, 0 elsewhere: what scores count. Throws InputError when it has none.
GESTALT_EXPORT cv::Mat_<std::uint16_t> scored_ground_truth(const Input& input);

/// The same of a scene that need not be segmented: neither camera nor colour is looked for in a folder.
GESTALT_EXPORT cv::Mat_<std::uint16_t> read_ground_truth(const std::filesystem::path& scene,
                                                         const ReadOptions& options = {});

/// Throws InputError, with what mends it, for ground truth of many scenes that has no object together: there is nothing
/// to learn from, and every score of it is full.
GESTALT_EXPORT void require_objects(std::int64_t objects);

/// Whether a folder has a label image of a scene, made by any program: `FOLDER/<scene>/<image>` or
/// `FOLDER/<scene>.png`.
GESTALT_EXPORT bool has_prediction(const std::filesystem::path& folder, const std::string& scene,
                                   const std::string& image);

/// That image. Throws InputError when it is missing, of another size than the scene's ground truth, or of
/// another run than the result.json beside it.
GESTALT_EXPORT cv::Mat_<std::uint16_t> read_prediction(const std::filesystem::path& folder, const std::string& scene,
                                                       const std::string& image, cv::Size size);

/// Fold of each scene for cross-validation, in [0, folds): the scenes of a category are dealt out in turn, so that
/// folds have about the same size and mixture. seed 0 deals in the given order, any other seed shuffles within the
/// categories first. Throws ConfigError unless 2 <= folds <= number of scenes.
GESTALT_EXPORT std::vector<int> deal_folds(const std::vector<std::string>& categories, int folds, std::uint64_t seed);

/// Decisions of a classifier on pairs it was not trained on.
struct GESTALT_EXPORT PairDecisions {
  std::int64_t true_positive = 0;
  std::int64_t false_positive = 0;
  std::int64_t true_negative = 0;
  std::int64_t false_negative = 0;

  /// A reliability diagram: the pairs by their probability, in bins of equal width.
  struct Bin {
    std::int64_t pairs = 0;
    std::int64_t positive = 0;
    double probability = 0;  ///< sum over the pairs
  };
  std::array<Bin, 10> bins;
  double squared_error = 0;  ///< sum of (p - positive)^2

  /// probability: p(same) in [0, 1]; from 1/2 on the pair is decided to be positive.
  void count(bool positive, double probability);

  std::int64_t pairs() const { return true_positive + false_positive + true_negative + false_negative; }

  /// Mean of (p - positive)^2; not a number without pairs.
  double brier_score() const;

  /// Mean difference of a bin's mean probability and its share of positive pairs, weighted by its pairs; not a number
  /// without pairs.
  double calibration_error() const;

  /// 1/2 (fp / (tn + fp) + fn / (tp + fn)); not a number without pairs of both kinds. (Paper, Eq. 13, with the
  /// denominators that its text asks for.)
  double balanced_error() const;
};

/// The counts, the balanced error and the calibration as a few lines of text. level: for the title.
GESTALT_EXPORT std::string format_pairs(const PairDecisions& pairs, const std::string& level);

/// {"true_positive": ..., "balanced_error": ..., "reliability": [{"pairs": ...}, ...]}
GESTALT_EXPORT nlohmann::ordered_json to_json(const PairDecisions& pairs);

}  // namespace gestalt
