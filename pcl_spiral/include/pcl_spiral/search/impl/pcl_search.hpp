// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Bodies of PCL's search structures, so that they exist for the user's own point types too. PCL compiles them for its own
 *  point types. The declarations here keep every including file from compiling them again (35 s to 8 s a file).
 */
#pragma once

#include <pcl/kdtree/impl/kdtree_flann.hpp>
#include <pcl/point_types.h>
#include <pcl/search/impl/kdtree.hpp>
#include <pcl/search/impl/organized.hpp>
#include <pcl/search/impl/search.hpp>

extern template class pcl::KdTreeFLANN<pcl::PointXYZ>;
extern template class pcl::KdTreeFLANN<pcl::PointXYZRGB>;
extern template class pcl::KdTreeFLANN<pcl::PointNormal>;
extern template class pcl::search::KdTree<pcl::PointXYZ>;
extern template class pcl::search::KdTree<pcl::PointXYZRGB>;
extern template class pcl::search::KdTree<pcl::PointNormal>;
extern template class pcl::search::OrganizedNeighbor<pcl::PointXYZ>;
extern template class pcl::search::OrganizedNeighbor<pcl::PointXYZRGB>;
extern template class pcl::search::OrganizedNeighbor<pcl::PointNormal>;
