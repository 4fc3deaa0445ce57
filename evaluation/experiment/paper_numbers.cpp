// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "paper_numbers.h"

#include <array>

namespace gestalt::paper {

namespace {

constexpr std::array<Counts, 12> counts{{{"learn", "boxes", 17, 38, 157, 48},
                                         {"learn", "stacked_boxes", 8, 20, 101, 58},
                                         {"learn", "occluded_objects", 8, 16, 73, 124},
                                         {"learn", "cylindric_objects", 12, 38, 104, 250},
                                         {"learn", "all", 45, 108, 435, 480},
                                         {"test", "boxes", 16, 36, 193, 290},
                                         {"test", "stacked_boxes", 8, 21, 121, 315},
                                         {"test", "occluded_objects", 7, 14, 58, 159},
                                         {"test", "cylindric_objects", 12, 42, 83, 419},
                                         {"test", "mixed_objects", 12, 81, 412, 1913},
                                         {"test", "complex_scene", 11, 162, 754, 10149},
                                         {"test", "all", 66, 356, 1621, 13240}}};

constexpr std::array<RelationScores, 11> structural{{{"r_co", 0.124, 39.5, 16.05, 93.9, 92.30, 95.47},
                                                     {"r_rs", 0.197, 41.2, 47.24, 94.9, 93.46, 95.49},
                                                     {"r_tr", 0.603, 43.7, 32.62, 93.9, 89.42, 95.50},
                                                     {"r_ga", 0.379, 41.3, 17.96, 94.1, 93.75, 95.49},
                                                     {"r_fo", 0.200, 44.0, 19.07, 95.0, 93.75, 95.48},
                                                     {"r_co3", 0.266, 38.6, 41.15, 88.8, 93.74, 95.48},
                                                     {"r_cu3", 1.703, 21.1, 92.21, 95.9, 66.85, 94.58},
                                                     {"r_cv3", 0.053, 43.7, 13.80, 90.9, 93.75, 95.50},
                                                     {"r_di2", 0.506, 30.3, 23.77, 95.7, 92.92, 95.74},
                                                     {"r_vd2", 0.737, 28.9, 23.08, 95.4, 94.48, 95.50},
                                                     {"all", none, 14.0, 93.75, 95.48, none, none}}};

constexpr std::array<RelationScores, 16> assembly{{{"r_co", 47.4e-3, 50.0, 93.75, 95.48, 87.16, 96.49},
                                                   {"r_rs", 13.8e-3, 50.0, 93.75, 95.48, 86.89, 96.52},
                                                   {"r_tr", 20.4e-3, 50.0, 93.75, 95.48, 90.19, 96.58},
                                                   {"r_ga", 25.3e-3, 50.0, 93.75, 95.48, 83.82, 97.00},
                                                   {"r_fo", 17.9e-3, 50.0, 93.75, 95.48, 90.93, 96.87},
                                                   {"r_md", 38.4e-3, 50.0, 93.75, 95.48, 92.33, 96.46},
                                                   {"r_nm", 34.7e-3, 50.0, 93.75, 95.48, 91.08, 96.21},
                                                   {"r_nv", 3.98e-3, 50.0, 93.75, 95.48, 86.19, 97.21},
                                                   {"r_ac", 18.5e-3, 50.0, 93.75, 95.48, 93.78, 96.13},
                                                   {"r_dn", 27.3e-3, 50.0, 93.75, 95.48, 83.52, 96.42},
                                                   {"r_cs", 25.7e-3, 50.0, 93.75, 95.48, 89.83, 96.81},
                                                   {"r_oc", 8.35e-3, 50.0, 93.75, 95.48, 83.98, 96.76},
                                                   {"r_ls", 7.01e-3, 50.0, 93.75, 95.48, 83.49, 96.85},
                                                   {"r_as", 7.27e-3, 50.0, 93.75, 95.48, 82.76, 96.60},
                                                   {"r_lg", 0.12e-3, 50.0, 93.75, 95.48, 59.97, 69.97},
                                                   {"all", none, 41.1, 89.98, 97.05, none, none}}};

constexpr std::array<CategoryScores, 8> categories{{{"boxes", 99.85, 98.11, 99.85, 98.85, 71.46, 78.28},
                                                    {"stacked_boxes", 93.26, 98.61, 93.34, 99.93, 64.37, 76.91},
                                                    {"occluded_objects", 99.84, 83.38, 99.80, 95.57, 76.69, 56.59},
                                                    {"cylindric_objects", 99.63, 97.79, 99.64, 98.26, 66.13, 84.67},
                                                    {"mixed_objects", 94.04, 98.08, 88.46, 98.28, 62.19, 74.12},
                                                    {"complex_scene", 89.12, 92.99, 82.72, 94.34, 55.61, 62.5},
                                                    {"all", 93.75, 95.48, 89.98, 97.05, 62.14, 70.93},
                                                    {willow_garage, 92.70, 97.12, 90.59, 97.12, 87.03, 86.01}}};

}  // namespace

std::span<const Counts> table_1() { return counts; }
std::span<const RelationScores> table_2() { return structural; }
std::span<const RelationScores> table_3() { return assembly; }
std::span<const CategoryScores> table_4() { return categories; }

}  // namespace gestalt::paper
