// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "gestalt/core/scene/frame.h"

namespace gestalt::bench {

/// What PCL segments: an organized cloud in metres, NaN where there is no depth.
using PclCloud = pcl::PointCloud<pcl::PointXYZRGBA>;

PclCloud::Ptr to_pcl(const Frame& frame);

/// IntegralImageNormalEstimation, with the settings of PCL's apps/src/organized_segmentation_demo.cpp.
pcl::PointCloud<pcl::Normal>::Ptr estimate_normals(const PclCloud::ConstPtr& cloud);

/// OrganizedMultiPlaneSegmentation with refinement on those normals, with the settings of the same program.
/// The plane of every point.
pcl::PointCloud<pcl::Label>::Ptr segment_planes(const PclCloud::ConstPtr& cloud,
                                                const pcl::PointCloud<pcl::Normal>::ConstPtr& normals);

/// Settings of PCL's LCCP. The defaults are those of PCL's examples/segmentation/example_lccp_segmentation.cpp.
struct LccpSettings {
  bool single_camera_transform = false;  ///< voxels grow with the depth
  bool sanity_check = false;             ///< the sanity criterion of Stein et al. (2014)
  unsigned minimum_size = 0;             ///< supervoxels; smaller segments join a neighbour
};

/// SupervoxelClustering and LCCPSegmentation. The segment of every point.
pcl::PointCloud<pcl::PointXYZL>::Ptr segment_convex(const PclCloud::ConstPtr& cloud, const LccpSettings& settings = {});

}  // namespace gestalt::bench
