// SPDX-License-Identifier: BSD-3-Clause
// MaterialRemoval with a mesh also measures against the faces as they are: what their bends do not explain is a gouge.
#include <pcl_spiral/verify/material_removal.h>

#include "support/filleted_parts.h"
#include "support/judged_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace face_gouges_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

using Path = pcl::PointCloud<ToolpathPoint>;
constexpr double fillet = 8.0; // radius of the trough's fillets

/** Floor of a trough and the feet of its walls. */
double
trough(double x, double)
{
  const double into = std::max(0.0, std::abs(x) - 20.0);
  return fillet - std::sqrt(fillet * fillet - into * into);
}

/** Its mesh with facets of 10 degrees, 60 mm long. */
pcl::PolygonMesh::Ptr
troughMesh()
{
  using Eigen::Vector2d;
  SweepGuide line;
  line.half = {0.0, 30.0};
  return sweptPart(RoundedProfile({{Vector2d(-28, 20)}, {Vector2d(-28, 0), fillet}, {Vector2d(28, 0), fillet}, {Vector2d(28, 20)}}, 10.0),
                   line)
      .mesh.polygons();
}

/** Hills with a radius of curvature of 25 mm. */
double
hills(double x, double y)
{
  return std::sin(x / 5.0) + 0.5 * std::sin(y / 7.0);
}

/** Rows along y, \p step apart, with the contacts of a ball on z = height(x, y), over |x|, |y| <= half. */
template <typename Height>
Path::Ptr
rows(Height height, double half, double step)
{
  constexpr double along = 0.2;
  Path::Ptr path(new Path);
  const int count = static_cast<int>(std::lround(2.0 * half / step)), points = static_cast<int>(std::lround(2.0 * half / along));
  for (int row = 0; row <= count; ++row)
    for (int i = 0; i <= points; ++i) {
      const double x = half * (2.0 * row / count - 1.0), y = (row % 2 == 0 ? 1.0 : -1.0) * half * (2.0 * i / points - 1.0);
      ToolpathPoint p;
      p.getVector3fMap() = Eigen::Vector3d(x, y, height(x, y)).cast<float>();
      p.getNormalVector3fMap() = heightNormal(height, x, y).template cast<float>();
      p.getAxisVector3fMap() = Eigen::Vector3f::UnitZ();
      p.turn = static_cast<float>(row);
      const double moved = i > 0 ? (p.getVector3fMap() - path->back().getVector3fMap()).norm() : 0.0; // lifted between rows
      p.arc_length = path->empty() ? 0.0 : path->back().arc_length + moved;
      path->push_back(p);
    }
  return path;
}

RemovalReport
removed(const pcl::PolygonMesh::ConstPtr& mesh, const Path::ConstPtr& path)
{
  pcl::PointCloud<pcl::PointXYZI> output;
  MaterialRemoval<pcl::PointXYZ> judge;
  judge.setInputMesh(mesh);
  judge.setSampleSpacing(0.4);
  judge.setInputToolpath(path);
  judge.setToolRadius(5.0);
  judge.setScallopHeight(0.02);
  judge.compute(output);
  EXPECT_TRUE(judge.getStatus().ok()) << judge.getStatus().message();
  return judge.getReport();
}

} // namespace

TEST(FaceGouges, ExactPathsOverFilletsHaveNoGougeIntoFaces)
{
  const double sagitta = fillet * (1.0 - std::cos(5.0 * M_PI / 180.0));
  const RemovalReport f = removed(troughMesh(), rows(trough, 26.0, 0.8));
  EXPECT_NEAR(f.face_depth.value, sagitta, 0.2 * sagitta); // of hollow facets, the ball reaches into the middle
  EXPECT_LT(f.face_gouge.value, 0.002);
  const RemovalReport wavy = removed(heightMesh(hills, 60.0, 40).made(), rows(hills, 24.0, 0.8));
  EXPECT_GT(wavy.face_depth.value, 0.01);
  EXPECT_LT(wavy.face_gouge.value, 0.002);
}

TEST(FaceGouges, ACutIntoAFlatFaceIsAGougeIntoFaces)
{
  for (const double depth : {0.05, 0.84}) {
    const Path::Ptr path = rows(trough, 26.0, 0.8);
    for (ToolpathPoint& p : *path)
      if (std::abs(p.x) < 20.0) // as faces that are curved by mistake
        p.z -= static_cast<float>(depth * (1.0 - p.x * p.x / 400.0));
    const RemovalReport f = removed(troughMesh(), path);
    EXPECT_NEAR(f.face_depth.value, depth, 0.01);
    EXPECT_GT(f.face_gouge.value, 0.9 * depth);
    EXPECT_LT(f.face_gouge.value, depth + 0.001);
    EXPECT_LT(f.face_gouge.position.head<2>().norm(), 35.0);
    EXPECT_NEAR(f.gouge.value, depth, 0.01);
  }
}

} // namespace face_gouges_test
