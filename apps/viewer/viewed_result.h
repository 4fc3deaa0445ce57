// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PolygonMesh.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <filesystem>
#include <string>

namespace gestalt::view {

using Cloud = pcl::PointCloud<pcl::PointXYZRGB>;

/// A scene's result as it is shown. Metres, camera frame: x right, y down, z forward.
struct ViewedResult {
  std::string name;
  Cloud::Ptr background;      ///< the points with depth that are in no object, grey
  Cloud::Ptr segments;        ///< these and those of the objects, in the colours of overlay.png
  Cloud::Ptr colours;         ///< the same points as the camera saw them; empty without colour
  pcl::PolygonMesh surfaces;  ///< of the objects, in their colours
};

/// Reads labelled.pcd and result.json of a folder that `gestalt segment --also pcd` has written. Throws InputError
/// naming the file and the remedy.
ViewedResult read_viewed_result(const std::filesystem::path& folder);

}  // namespace gestalt::view
