// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The reference for times: PCL's own normals and boundary points of the same cloud.
 */
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

namespace pcl_spiral::test {

using NormalCloud = pcl::PointCloud<pcl::Normal>;
using Tree = pcl::search::KdTree<pcl::PointXYZ>;

/** NormalEstimationOMP with 20 neighbours; also builds \p tree if it is new to the cloud. */
NormalCloud::Ptr pclNormals(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud, const Tree::Ptr& tree, int threads);

/** BoundaryEstimation with 30 neighbours, which PCL runs on one thread. */
pcl::PointCloud<pcl::Boundary> pclBoundary(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud, const NormalCloud::ConstPtr& normals,
                                           const Tree::Ptr& tree);

/** Seconds of one after the other, with one tree for both. */
struct PairSeconds {
  double normals = 0.0; ///< with the tree
  double boundary = 0.0;

  double sum() const { return normals + boundary; }
};

PairSeconds timePclPair(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud, int threads);

} // namespace pcl_spiral::test
