// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "pcl_segmentation.h"

#include <pcl/common/angles.h>
#include <pcl/features/integral_image_normal.h>
#include <pcl/segmentation/lccp_segmentation.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>
#include <pcl/segmentation/supervoxel_clustering.h>

#include <limits>

namespace gestalt::bench {

PclCloud::Ptr to_pcl(const Frame& frame) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  PclCloud::Ptr cloud(new PclCloud(unsigned(frame.width()), unsigned(frame.height())));
  cloud->is_dense = false;
  for (int v = 0; v < frame.height(); ++v)
    for (int u = 0; u < frame.width(); ++u) {
      pcl::PointXYZRGBA& point = cloud->at(u, v);
      const cv::Vec3f& p = frame.points(v, u);
      const bool measured = frame.depth(v, u) > 0;
      point.x = measured ? p[0] : nan;
      point.y = measured ? p[1] : nan;
      point.z = measured ? p[2] : nan;
      if (!frame.has_colour()) continue;
      const auto& colour = frame.colour.at<cv::Vec3b>(v, u);
      point.b = colour[0];
      point.g = colour[1];
      point.r = colour[2];
    }
  return cloud;
}

pcl::PointCloud<pcl::Normal>::Ptr estimate_normals(const PclCloud::ConstPtr& cloud) {
  pcl::IntegralImageNormalEstimation<pcl::PointXYZRGBA, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod(estimation.COVARIANCE_MATRIX);
  estimation.setMaxDepthChangeFactor(0.02F);
  estimation.setNormalSmoothingSize(20);
  estimation.setInputCloud(cloud);
  pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  estimation.compute(*normals);
  return normals;
}

pcl::PointCloud<pcl::Label>::Ptr segment_planes(const PclCloud::ConstPtr& cloud,
                                                const pcl::PointCloud<pcl::Normal>::ConstPtr& normals) {
  pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZRGBA, pcl::Normal, pcl::Label> segmentation;
  segmentation.setMinInliers(10000);
  segmentation.setAngularThreshold(pcl::deg2rad(3.0));
  segmentation.setDistanceThreshold(0.02);
  segmentation.setInputCloud(cloud);
  segmentation.setInputNormals(normals);
  std::vector<pcl::PlanarRegion<pcl::PointXYZRGBA>, Eigen::aligned_allocator<pcl::PlanarRegion<pcl::PointXYZRGBA>>>
      regions;
  std::vector<pcl::ModelCoefficients> coefficients;
  std::vector<pcl::PointIndices> inliers, label_indices, boundaries;
  pcl::PointCloud<pcl::Label>::Ptr labels(new pcl::PointCloud<pcl::Label>);
  segmentation.segmentAndRefine(regions, coefficients, inliers, labels, label_indices, boundaries);
  return labels;
}

pcl::PointCloud<pcl::PointXYZL>::Ptr segment_convex(const PclCloud::ConstPtr& cloud, const LccpSettings& settings) {
  constexpr float voxel_resolution = 0.0075F, seed_resolution = 0.03F;  // m
  pcl::SupervoxelClustering<pcl::PointXYZRGBA> clustering(voxel_resolution, seed_resolution);
  clustering.setUseSingleCameraTransform(settings.single_camera_transform);
  clustering.setInputCloud(cloud);
  clustering.setColorImportance(0);
  clustering.setSpatialImportance(1);
  clustering.setNormalImportance(4);
  std::map<std::uint32_t, pcl::Supervoxel<pcl::PointXYZRGBA>::Ptr> supervoxels;
  clustering.extract(supervoxels);
  std::multimap<std::uint32_t, std::uint32_t> adjacency;
  clustering.getSupervoxelAdjacency(adjacency);

  pcl::LCCPSegmentation<pcl::PointXYZRGBA> segmentation;
  segmentation.setConcavityToleranceThreshold(10);
  segmentation.setSanityCheck(settings.sanity_check);
  segmentation.setSmoothnessCheck(true, voxel_resolution, seed_resolution, 0.1F);
  segmentation.setKFactor(0);
  segmentation.setInputSupervoxels(supervoxels, adjacency);
  segmentation.setMinSegmentSize(settings.minimum_size);
  segmentation.segment();
  pcl::PointCloud<pcl::PointXYZL>::Ptr labelled = clustering.getLabeledCloud();
  segmentation.relabelCloud(*labelled);
  return labelled;
}

}  // namespace gestalt::bench
