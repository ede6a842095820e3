// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A stage used again: clouds of other sizes, other point types, indices, no cloud. It must never give an earlier result.
 */
#pragma once

#include "support/sampling.h"
#include "support/surfaces.h"

#include <pcl/common/io.h>
#include <pcl/pcl_base.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pcl_spiral::test {

using Values = std::vector<double>; ///< the result of a run, in numbers that are not indices of points

constexpr double dome_radius = 80.0, dome_height = 45.0;

inline std::vector<Eigen::Vector3d>
dome(std::size_t count, std::uint64_t seed)
{
  return sampleUniform(*spheroidCap(dome_radius, dome_height), count, seed).points;
}

inline void
addLine(const Polyline& line, Values& values)
{
  for (const Eigen::Vector3d& p : line)
    values.insert(values.end(), {p.x(), p.y(), p.z()});
}

template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr
cloudOf(const std::vector<Eigen::Vector3d>& points)
{
  typename pcl::PointCloud<PointT>::Ptr cloud(new pcl::PointCloud<PointT>);
  pcl::copyPointCloud(*toCloud(points), *cloud);
  return cloud;
}

template <template <typename> class Stage, typename PointT>
Values
fresh(const std::vector<Eigen::Vector3d>& points)
{
  Stage<PointT> stage;
  stage.setInputCloud(cloudOf<PointT>(points));
  return stage.run();
}

/** \p Stage is one adaptor per class: run computes and returns numbers, none on failure. Outputs are kept between runs. */
template <template <typename> class Stage>
void
checkReuse(const char* name)
{
  SCOPED_TRACE(name);
  using Point = pcl::PointXYZ;
  const auto large = dome(6000, 1), small = dome(2500, 2);
  const Values of_large = fresh<Stage, Point>(large), of_small = fresh<Stage, Point>(small);
  ASSERT_FALSE(of_large.empty());
  ASSERT_FALSE(of_small.empty());
  Stage<Point> stage;
  const auto run = [&](const pcl::PointCloud<Point>::ConstPtr& cloud) {
    stage.setInputCloud(cloud);
    return stage.run();
  };
  const pcl::PointCloud<Point>::ConstPtr none, empty(new pcl::PointCloud<Point>);
  EXPECT_EQ(run(cloudOf<Point>(large)), of_large);
  EXPECT_EQ(run(cloudOf<Point>(small)), of_small) << "a second, smaller cloud";
  EXPECT_EQ(run(cloudOf<Point>(large)), of_large) << "a third, larger cloud";
  EXPECT_TRUE(run(empty).empty());
  EXPECT_FALSE(stage.getStatus().ok());
  EXPECT_TRUE(run(none).empty());
  EXPECT_FALSE(stage.getStatus().ok());
  EXPECT_EQ(run(cloudOf<Point>(small)), of_small) << "after a failure";

  // The points of a larger cloud that are also in the small cloud.
  std::vector<Eigen::Vector3d> both = large;
  both.insert(both.end(), small.begin(), small.end());
  pcl::IndicesPtr indices(new pcl::Indices);
  for (std::size_t i = 0; i < small.size(); ++i)
    indices->push_back(static_cast<pcl::index_t>(large.size() + i));
  Stage<Point> chosen;
  chosen.setInputCloud(cloudOf<Point>(both));
  chosen.setIndices(indices);
  if (std::string(name) == "CentroidBoundaryEstimation") // in this class and the next, the other points are support, as in PCL
    EXPECT_EQ(chosen.run().size(), small.size());
  else if (std::string(name) == "MLSProjector")
    EXPECT_EQ(chosen.run(), (fresh<Stage, Point>(both)));
  else
    EXPECT_EQ(chosen.run(), of_small) << "by indices";
  chosen.setIndices(pcl::IndicesPtr(new pcl::Indices{static_cast<pcl::index_t>(both.size())}));
  EXPECT_TRUE(chosen.run().empty()) << "an index outside the cloud";
  EXPECT_FALSE(chosen.getStatus().ok());

  EXPECT_EQ((fresh<Stage, pcl::PointXYZRGB>(large)), of_large);
  EXPECT_EQ((fresh<Stage, pcl::PointNormal>(large)), of_large);
}

} // namespace pcl_spiral::test
