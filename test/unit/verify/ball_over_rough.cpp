// SPDX-License-Identifier: BSD-3-Clause
// Gouges of a ball that touches the mesh where a local fit, extended over the width of the ball, would be inside the ball.
#include <pcl_spiral/verify/material_removal.h>

#include "support/judged_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ball_over_rough_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double R = 20.0;

/** Contact at \p p of a ball with its centre along \p normal. */
ToolpathPoint
touching(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, double arc_length)
{
  ToolpathPoint point;
  point.getVector3fMap() = p.cast<float>();
  point.getNormalVector3fMap() = normal.normalized().cast<float>();
  point.getAxisVector3fMap() = Eigen::Vector3f::UnitZ();
  point.arc_length = arc_length;
  return point;
}

RemovalReport
removed(const pcl::PolygonMesh::ConstPtr& mesh, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path)
{
  pcl::PointCloud<pcl::PointXYZI> output;
  MaterialRemoval<pcl::PointXYZ> judge;
  judge.setInputMesh(mesh);
  judge.setSampleSpacing(0.4);
  judge.setInputToolpath(path);
  judge.setToolRadius(R);
  judge.setScallopHeight(0.05);
  judge.compute(output);
  EXPECT_TRUE(judge.getStatus().ok()) << judge.getStatus().message();
  return judge.getReport();
}

} // namespace

TEST(BallOverRough, ARippleNarrowerThanTheBallIsGougedByItsOwnHeightAlone)
{
  constexpr double height = 0.15, length = 8.0;
  const auto ripple = [](double x, double) { return -height * std::cos(2.0 * M_PI * x / length); };
  const auto path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  for (double y = -20.0; y <= 20.0; y += 0.5) // in the hollow at x = 0, of radius 10.8 mm
    path->push_back(touching({0.0, y, -height}, Eigen::Vector3d::UnitZ(), y + 20.0));
  double nearest = R;
  for (double x = 0.0; x < 8.0; x += 1e-4)
    nearest = std::min(nearest, std::hypot(x, R - height - ripple(x, 0.0)));
  const RemovalReport figures = removed(heightMesh(ripple, 60.0, 60).made(), path);
  EXPECT_NEAR(figures.gouge.value, R - nearest, 0.005); // 0.052 mm; only from the fit in the hollow 2.3 mm
}

TEST(BallOverRough, ABallRolledOverTheRimGougesNothing)
{
  const auto flat = [](double, double) { return 0.0; };
  const auto path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  for (double y = -15.0; y <= 15.0; y += 0.5) // on the rim at x = 20, 45 degrees over it
    path->push_back(touching({20.0, y, 0.0}, {1.0, 0.0, 1.0}, y + 15.0));
  EXPECT_LT(removed(heightMesh(flat, 40.0, 20).made(), path).gouge.value, 1e-4);
}

} // namespace ball_over_rough_test
