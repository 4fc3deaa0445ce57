// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "gestalt/frame.h"

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

/// SupervoxelClustering and LCCPSegmentation with the default settings of PCL's
/// examples/segmentation/example_lccp_segmentation.cpp. The segment of every point, as that program has it.
pcl::PointCloud<pcl::PointXYZL>::Ptr segment_convex(const PclCloud::ConstPtr& cloud);

}  // namespace gestalt::bench
