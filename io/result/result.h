// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <opencv2/core.hpp>
#include <set>
#include <string>
#include <vector>

#include "gestalt/core/base/output_file.h"
#include "gestalt/core/pipeline/segmenter.h"
#include "gestalt/core/scene/scene.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

/// The names of all files that the folder of a scene's results may have.
GESTALT_EXPORT const std::set<std::string>& result_names();

/// Everything that was found in a scene and how: the input's absolute path, camera, segments with their roles, surfaces
/// and pixel counts, patches with their surface models, pairs with all relation values and p, milliseconds of each
/// level. config is ConfigTree::to_json(). Pairs and patches count from 0, segments have their labels.
GESTALT_EXPORT nlohmann::json result_json(const Input& input, const SegmentedFrame& found,
                                          const nlohmann::json& config);

/// The colour of a segment or patch in pictures and meshes, blue green red, by its number.
GESTALT_EXPORT cv::Vec3b segment_colour(int label);

/// CV_8UC3: the objects over the colour image (over shaded depth when there is none), each tinted, outlined and with
/// its label; background as it is, pixels of no segment dimmed. Gaps of up to 64 such pixels are drawn as what is
/// beside them.
GESTALT_EXPORT cv::Mat draw_segments(const Frame& frame, const Segmentation& segmentation);

/// CV_8UC3: every patch after surface merging in a colour of its own, black where there is none.
GESTALT_EXPORT cv::Mat draw_patches(const cv::Mat_<int>& labels);

/// CV_8UC3, twice the frame's size: the twelve cheapest closures (tinted); boundary lines, green where a surface ends
/// before something farther or nothing, blue where it meets what is as near, grey where something else ends it; the 80
/// cheapest collinearities (violet) and L-junctions (orange) between surfaces; T-junctions (red crosses).
GESTALT_EXPORT cv::Mat draw_boundary_lines(const Scene& scene);

/// CV_8UC3: unit normals as colours, (x + 1) / 2 in red, (y + 1) / 2 in green and -z in blue, so that what faces the
/// camera is blue; black where there is none.
GESTALT_EXPORT cv::Mat draw_normals(const cv::Mat_<cv::Vec3f>& normals);

/// The normal of its surface at each pixel's foot, towards the camera; (0, 0, 0) where there is no surface.
GESTALT_EXPORT cv::Mat_<cv::Vec3f> surface_normals(const Frame& frame, const SurfaceSet& surfaces);

/// CV_8UC3, twice the frame's size: the graph that was cut, over the dimmed image. A disc at the pixel of each surface
/// that is nearest to their mean; a line for each edge, from red (p = 0) by yellow to green (p = 1), the likeliest on
/// top: thick at the structural level, thin at the assembly level, of which those below p = 0.5 are left out.
GESTALT_EXPORT cv::Mat draw_graph(const Frame& frame, const SurfaceSet& surfaces, const Graph& graph);

/// Writes labels.png, objects.png (the same with background at 0), overlay.png, patches.png and result.json, for
/// unorganized clouds also labels.pcd (x y z label, the original points in their order; label 0 = in no segment), into
/// a folder, and the files in more: all of them or, with OutputError, none. result.json comes last, and an old one is
/// removed first, and with it what it has written and is not written now: where it is, all files are and belong
/// together. It has their digests, by which readers see it where somebody else has changed one. tracks, if given,
/// becomes its key of this name.
GESTALT_EXPORT void write_result(const OutputPath& folder, const Input& input, const SegmentedFrame& found,
                                 const nlohmann::json& config, std::vector<OutputFile> more = {},
                                 const nlohmann::json* tracks = nullptr);

}  // namespace gestalt
