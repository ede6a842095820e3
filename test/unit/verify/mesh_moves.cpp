// SPDX-License-Identifier: BSD-3-Clause
// Straight moves of cutters over meshes: obstacles between two locations are not gouged, and moves are not halved without need.
#include <pcl_spiral/core/impl/swept_error.h>

#include "support/located_on_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mesh_moves_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

constexpr double tolerance = 0.01, R = 5.0;
const CutterShape ball_end = CutterShape::ball(R, 3.0);

void
addBox(PlainMesh& m, const Vector3d& low, const Vector3d& high)
{
  const auto at = [&](int x, int y, int z) { return Vector3d(x ? high.x() : low.x(), y ? high.y() : low.y(), z ? high.z() : low.z()); };
  m.addQuad(at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0));
  m.addQuad(at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
  m.addQuad(at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1));
  m.addQuad(at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0));
  m.addQuad(at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0));
  m.addQuad(at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1));
}

PlainMesh
ground()
{
  PlainMesh m;
  m.addQuad({-30, -30, 0}, {30, -30, 0}, {30, 30, 0}, {-30, 30, 0});
  return m;
}

/** A row along x, one point per 4 mm, moved down onto the mesh. */
DrivePoints
row()
{
  DrivePoints drive;
  for (double x = -14.0; x <= 14.0; x += 4.0)
    drive.push_back({{x, 0.0, 0.0}, Vector3d::UnitZ(), none});
  return drive;
}

ToolLocations
led(const PlainMesh& mesh, double path_tolerance, BisectionReport& figures, int threads = 2)
{
  Location location;
  location.setInputMesh(mesh.polygons());
  location.setCutter(ball_end);
  location.setDrivePoints(row());
  location.setPathTolerance(path_tolerance);
  location.setNumberOfThreads(threads);
  ToolLocations locations;
  location.compute(locations);
  EXPECT_TRUE(location.getStatus().ok()) << location.getStatus().message();
  figures = location.getBisectionReport();
  return locations;
}

/** Largest depth along the moves of places on the edges of \p mesh, 0.05 mm apart. */
double
deepest(const PlainMesh& mesh, const ToolLocations& row)
{
  const CutterProfile cutter(ball_end);
  double depth = -1e300;
  for (const auto& face : mesh.faces)
    for (int k = 0; k < 3; ++k) {
      const Vector3d a = mesh.corners[face[k]], b = mesh.corners[face[(k + 1) % 3]];
      const int steps = static_cast<int>((b - a).norm() / 0.05) + 1;
      for (int s = 0; s <= steps; ++s)
        for (std::size_t i = 0; i + 1 < row.size(); ++i)
          for (double t = 0.0; t <= 1.0; t += 0.1)
            depth = std::max(depth, depthOf(a + static_cast<double>(s) / steps * (b - a), cutter,
                                            onTheWay({row[i].tip, row[i].axis}, {row[i + 1].tip, row[i + 1].axis}, t)));
    }
  return depth;
}

/** Obstacles beside a row or across it, touched between two locations but at no location. */
std::vector<PlainMesh>
traps()
{
  std::vector<PlainMesh> all(4, ground());
  addBox(all[0], {-0.9, 4.7, -1.0}, {-0.4, 5.2, 8.0});    // a pin
  addBox(all[1], {0.6, 4.75, 6.0}, {0.9, 25.0, 6.3});     // an arm above the ball's centre
  addBox(all[2], {-0.1, -20.0, -1.0}, {0.1, 20.0, 0.15}); // a ridge in the middle
  addBox(all[3], {0.75, -20.0, -1.0}, {0.85, 20.0, 0.1}); // and beside it
  return all;
}

} // namespace

TEST(MeshMoves, DoNotCutWhatStandsBetweenTwoLocations)
{
  for (const PlainMesh& mesh : traps()) {
    BisectionReport figures;
    const double before = deepest(mesh, led(mesh, 0.0, figures));
    const ToolLocations row = led(mesh, tolerance, figures);
    const double after = deepest(mesh, row);
    std::printf("%.4f mm deep on the way before, %.4f after, %zu put in\n", before, after, figures.inserted);
    EXPECT_GT(before, 5.0 * tolerance);
    EXPECT_LE(after, tolerance);
    EXPECT_EQ(figures.unresolved, 0u);
    EXPECT_GT(figures.inserted, 0u);
  }
}

TEST(MeshMoves, LeaveNothingInAGrooveBetweenTwoLocations)
{
  for (const double width : {0.8, 1.2, 1.6})
    for (const double x : {-1.0, 0.0, 0.7}) { // between locations at -2 and 2
      PlainMesh mesh;
      const double a = x - 0.5 * width, b = x + 0.5 * width;
      mesh.addQuad({-30, -30, 0}, {a, -30, 0}, {a, 30, 0}, {-30, 30, 0});
      mesh.addQuad({a, -30, 0}, {a, -30, -3}, {a, 30, -3}, {a, 30, 0});
      mesh.addQuad({a, -30, -3}, {b, -30, -3}, {b, 30, -3}, {a, 30, -3});
      mesh.addQuad({b, -30, -3}, {b, -30, 0}, {b, 30, 0}, {b, 30, -3});
      mesh.addQuad({b, -30, 0}, {30, -30, 0}, {30, 30, 0}, {b, 30, 0});
      BisectionReport figures;
      const ToolLocations row = led(mesh, tolerance, figures);
      DrivePoints between;
      for (std::size_t i = 0; i + 1 < row.size(); ++i)
        for (double t = 0.0; t < 1.0; t += 0.05)
          between.push_back({row[i].tip + t * (row[i + 1].tip - row[i].tip), Vector3d::UnitZ(), none});
      const Located touching = onMesh(mesh.polygons(), ball_end, between);
      double left = 0.0;
      for (std::size_t i = 0; i < between.size(); ++i)
        left = std::max(left, (between[i].position - touching.locations[i].tip).z());
      EXPECT_LE(left, tolerance) << width << ' ' << x;
    }
}

TEST(MeshMoves, AreTheSameForAnyNumberOfThreads)
{
  for (const PlainMesh& mesh : traps()) {
    BisectionReport one, three;
    const ToolLocations a = led(mesh, tolerance, one, 1), b = led(mesh, tolerance, three, 3);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
      ASSERT_TRUE(a[i].tip == b[i].tip && a[i].contact == b[i].contact && a[i].cloud_index == b[i].cloud_index) << i;
    EXPECT_EQ(one.largest_error, three.largest_error);
    EXPECT_EQ(one.worst_place, three.worst_place);
  }
}

TEST(MeshMoves, OverThePlaneAreAllowedAtAnyLengthToBallsThatDoNotTurn)
{
  const LocationMesh mesh(ground().surface());
  const CutterPlace from{{-15, 0, 0}, Vector3d::UnitZ()}, to{{15, 0, 0}, Vector3d::UnitZ()};
  const CutterPlace near{{-14.8, 0, 0}, Vector3d::UnitZ()}, turned{near.tip, Vector3d(0.02, 0.0, 1.0).normalized()};
  const CutterLocationEngine balls(mesh, CutterProfile(ball_end), {});
  EXPECT_LE(balls.moveError(from, to, 0.5 * tolerance), 0.5 * tolerance);
  EXPECT_EQ(balls.moveError(from, near, 0.5 * tolerance), sweptError(balls.profile(), from, near)); // smaller than allowed
  EXPECT_EQ(balls.moveError(from, turned, 1e-6), sweptError(balls.profile(), from, turned));
  for (const CutterShape& shape : {CutterShape::bullNose(R, 2.0, 3.0), CutterShape::taper(R, 3.0, 20.0)}) {
    const CutterLocationEngine other(mesh, CutterProfile(shape), {});
    EXPECT_EQ(other.moveError(from, near, 1e-6), sweptError(other.profile(), from, near));
  }
}

TEST(MeshMoves, CutNoDeeperThanTheBoundOrTheMesh)
{
  PlainMesh mesh = ground();
  addBox(mesh, {-0.1, -20.0, -1.0}, {0.1, 20.0, 0.15});
  const LocationMesh ridge(mesh.surface());
  const CutterLocationEngine locator(ridge, CutterProfile(ball_end), {});
  const auto at = [](double x, double z) { return CutterPlace{{x, 0.0, z}, Vector3d::UnitZ()}; };
  const double sag = 5e-4;
  EXPECT_NEAR(locator.moveError(at(-2, 0), at(2, 0), 0.005), 0.15, sag + 1e-6);       // the ridge's height
  EXPECT_NEAR(locator.moveError(at(-2, -0.1), at(2, -0.1), 0.005), 0.25, sag + 1e-6); // both ends cut, and so does the move
  EXPECT_EQ(locator.moveError(at(-0.4, -0.1), at(0.4, -0.1), 0.005),
            sweptError(locator.profile(), at(-0.4, -0.1), at(0.4, -0.1))); // what the move adds to the ends
}

} // namespace mesh_moves_test
