// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <span>
#include <string_view>

namespace gestalt::paper {

// The tables of Richtsfeld, Mörwald, Prankl, Zillich, Vincze, "Learning of perceptual grouping for object segmentation
// on RGB-D data", Journal of Visual Communication and Image Representation 25(1), 2014. P, R and BER in percent.

/// A row of Table 1.
struct Counts {
  std::string_view set;       ///< "learn" or "test"
  std::string_view category;  ///< "all" for the total
  int images;
  int objects;
  int structural;  ///< relations of the structural level
  int assembly;
};
std::span<const Counts> table_1();

/// A row of Table 2 or 3: one value of the feature vector alone, and (*) all others without it. The row "all" has no
/// F-score and no starred values: they are not numbers.
struct RelationScores {
  std::string_view value;  ///< by our name: Table 3's r_od is r_oc everywhere else
  double f_score;
  double balanced_error;
  double precision;
  double recall;
  double precision_without;
  double recall_without;
};
std::span<const RelationScores> table_2();
std::span<const RelationScores> table_3();

/// What stands for a value that the paper does not have.
inline constexpr double none = std::numeric_limits<double>::quiet_NaN();
inline constexpr RelationScores unknown_relation{"", none, none, none, none, none, none};

/// A row of Table 4: of the test set, or the Willow Garage dataset.
struct CategoryScores {
  std::string_view category;  ///< "all" for the total of the test set
  double structural_precision;
  double structural_recall;
  double assembly_precision;  ///< with both levels
  double assembly_recall;
  double mishra_precision;  ///< the method of Mishra et al. [28] there
  double mishra_recall;
};
std::span<const CategoryScores> table_4();
inline constexpr CategoryScores unknown_category{"", none, none, none, none, none, none};

/// The row of Table 4 that is of another dataset.
inline constexpr std::string_view willow_garage = "Willow Garage";

}  // namespace gestalt::paper
