// SPDX-License-Identifier: BSD-3-Clause
// Straight moves of ball cutters over triangles: the depth of the cut, against a search over move and triangle.
#include "cutter/mesh_sweep.h"

#include "support/plain_mesh.h"
#include "support/searched_triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesh_sweep_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double as_they_are = std::numeric_limits<double>::infinity();

struct Move {
  double radius;
  Vector3d from, to, axis; ///< the ball's centre

  /** Depth of \p p in ball and shank at share \p t of the way. */
  double depthAt(const Vector3d& p, double t) const
  {
    const Vector3d off = p - from - t * (to - from);
    return radius - (off - std::max(0.0, off.dot(axis)) * axis).norm();
  }
};

/** Moves: level, plunging, along x with the axis z, of zero length, or random. */
Move
randomMove(Random& random)
{
  const auto any = [&] { return Vector3d(random.normal(), random.normal(), random.normal()).normalized(); };
  const double length = std::pow(10.0, random.uniform(-3.0, 1.2));
  Move move{random.uniform(0.5, 6.0), {random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-8, 8)}, {}, any()};
  Vector3d way = length * any();
  switch (random.below(5)) {
  case 0:
    way -= way.dot(move.axis) * move.axis;
    break;
  case 1:
    way = random.uniform(-length, length) * move.axis;
    break;
  case 2:
    move.axis = Vector3d::UnitZ(), way = length * Vector3d::UnitX();
    break;
  case 3:
    way *= static_cast<double>(random.below(2));
    break;
  default:
    break;
  }
  move.to = move.from + way;
  return move;
}

/** The largest depth over a triangle, by three golden sections: the depth is concave over move and triangle together. */
double
searchedDepth(const Matrix3d& c, const Move& move)
{
  return largest([&](double t) {
    return largest([&](double u) {
      const Vector3d a = (1.0 - u) * c.col(0) + u * c.col(1), b = (1.0 - u) * c.col(0) + u * c.col(2);
      return largest([&](double w) { return move.depthAt((1.0 - w) * a + w * b, t); });
    });
  });
}

PatchCell
flatCell(const Matrix3d& corners)
{
  return {corners, Matrix3d::Zero()};
}

double
depthIn(const PatchTree& patches, const Move& move, double sag, double allowed)
{
  return MeshSweep(patches, move.radius, sag).depth(move.from, move.to, move.axis, allowed);
}

void
cutUp(const PatchCell& cell, double sag, std::vector<PatchCell>& flat)
{
  if (!(cell.sag() > sag))
    flat.push_back(flatCell(cell.corners));
  else
    for (int k = 0; k < 4; ++k)
      cutUp(cell.quarter(k), sag, flat);
}

} // namespace

TEST(MeshSweep, IntoATriangleIsAsDeepAsSearchFinds)
{
  Random random(11);
  int pierced = 0, beside = 0;
  for (int i = 0; i < 400; ++i) {
    const Move move = randomMove(random);
    Matrix3d corners = randomTriangle(5.0, random);
    if (i % 4 == 0) // round a place of the strip
      corners.colwise() += Vector3d(move.from + random.uniform(0.0, 1.0) * (move.to - move.from) + random.uniform(0.0, 3.0) * move.axis -
                                    corners.rowwise().mean());
    const double expected = searchedDepth(corners, move), found = depthIn(PatchTree({flatCell(corners)}), move, 0.0, -1e3);
    ASSERT_NEAR(found, expected, 1e-6) << i;
    pierced += found == move.radius;
    beside += found < move.radius;
  }
  EXPECT_GT(pierced, 20);
  EXPECT_GT(beside, 200);
}

TEST(MeshSweep, IntoATriangleThatStandsInTheStripOfItsAxis)
{
  Random random(12);
  for (int i = 0; i < 100; ++i) { // corners in the plane y = 0, as is the move
    Matrix3d corners = randomTriangle(5.0, random);
    corners.row(1).setZero();
    const Move move{2.0, {-2.0, 0.0, random.uniform(-3, 3)}, {random.uniform(-2, 2), 0.0, random.uniform(-3, 3)}, Vector3d::UnitZ()};
    ASSERT_NEAR(depthIn(PatchTree({flatCell(corners)}), move, 0.0, -1e3), searchedDepth(corners, move), 1e-6) << i;
  }
}

TEST(MeshSweep, IntoASoupIsTheDeepestOfAllAndOfNoPlaceSampledInIt)
{
  Random random(13);
  std::vector<PatchCell> soup;
  for (int i = 0; i < 4000; ++i) {
    Matrix3d c = randomTriangle(0.5, random);
    c.colwise() += Vector3d(random.uniform(-40, 40), random.uniform(-40, 40), random.uniform(-20, 20));
    soup.push_back(flatCell(c));
  }
  const PatchTree patches(soup);
  for (int i = 0; i < 60; ++i) {
    const Move move = randomMove(random);
    const double allowed = random.uniform(-2.0, 0.8 * move.radius);
    double deepest = allowed, sampled = allowed;
    for (const PatchCell& cell : soup) {
      deepest = std::max(deepest, depthIn(PatchTree({cell}), move, 0.0, -1e3));
      for (int k = 0; k < 20; ++k) {
        const double u = random.uniform(0.0, 1.0), w = random.uniform(0.0, 1.0 - u);
        sampled = std::max(sampled, move.depthAt(cell.corners * Vector3d(1.0 - u - w, u, w), k / 19.0));
      }
    }
    const double found = depthIn(patches, move, 0.0, allowed);
    ASSERT_NEAR(found, deepest, 1e-9) << i;
    ASSERT_LE(sampled, found + 1e-9) << i;
    EXPECT_EQ(depthIn(patches, move, 0.0, found + 1e-6), found + 1e-6);
  }
}

TEST(MeshSweep, IntoCurvedTrianglesIsTheDeepestOfTheirParts)
{
  Random random(14);
  const auto wavy = [](double x, double y) { return 3.0 * std::sin(x / 4.0) + 2.0 * std::cos(y / 5.0 + x / 9.0); };
  const PatchTree faces = facesOf(*graphMesh(wavy, 12.0, 2.0).surface());
  constexpr double sag = 2e-3;
  std::vector<PatchCell> parts;
  for (std::size_t i = 0; i < faces.size(); ++i)
    cutUp(faces.cell(i), sag, parts);
  EXPECT_GT(parts.size(), 10 * faces.size());
  const PatchTree flat(parts);
  for (int i = 0; i < 300; ++i) {
    const Move move = randomMove(random);
    ASSERT_NEAR(depthIn(faces, move, sag, -0.5), depthIn(flat, move, as_they_are, -0.5), 1e-9) << i;
  }
}

TEST(MeshSweep, TouchesWhereNoPlaceOfTheWayIsFartherOffAllTriangles)
{
  Random random(15);
  constexpr int steps = 400;
  int touching = 0, free = 0;
  for (int i = 0; i < 400; ++i) {
    const Move move = randomMove(random);
    std::vector<PatchCell> cells;
    for (int k = 0; k < 12; ++k) {
      Matrix3d c = randomTriangle(5.0, random);
      c.colwise() += Vector3d(move.from + random.uniform(0.0, 1.0) * (move.to - move.from) - 0.7 * c.rowwise().mean());
      cells.push_back(flatCell(c));
    }
    double farthest = 0.0;
    for (int s = 0; s <= steps; ++s) {
      const Vector3d centre = move.from + static_cast<double>(s) / steps * (move.to - move.from);
      double nearest = as_they_are;
      for (const PatchCell& cell : cells)
        nearest = std::min(nearest, (cell.corners * nearestOnTriangle(cell.corners, centre) - centre).norm());
      farthest = std::max(farthest, nearest);
    }
    const double between = 0.5 * (move.to - move.from).norm() / steps, reach = farthest * random.uniform(0.8, 1.2);
    const bool found = MeshSweep(PatchTree(cells), move.radius, 0.0).touches(move.from, move.to, move.axis, reach - move.radius);
    if (found)
      ASSERT_GT(reach, farthest - 1e-6) << i;
    else
      ASSERT_LT(reach, farthest + between + 1e-6) << i;
    ++(found ? touching : free);
  }
  EXPECT_GT(touching, 100);
  EXPECT_GT(free, 100);
}

TEST(MeshSweep, TouchesCurvedTrianglesToTheSag) // on a sphere, the ends of the move are the farthest from it
{
  const auto round = [](double x, double y) { return std::sqrt(900.0 - x * x - y * y); };
  const PatchTree faces = facesOf(*graphMesh(round, 6.0, 2.0).surface());
  const MeshSweep sweep(faces, 5.0, 1e-4);
  for (const double angle : {0.0, 0.5, 1.0}) {
    const Vector3d side(std::cos(angle), std::sin(angle), 0.0), up = std::sqrt(35.0 * 35.0 - 1.0) * Vector3d::UnitZ();
    for (const double lift : {0.0, 0.002, 0.01}) {
      const Vector3d raised = up + lift * Vector3d::UnitZ();
      EXPECT_TRUE(sweep.touches(raised - side, raised + side, Vector3d::UnitZ(), 1.4 * lift + 2e-3)) << angle << ' ' << lift;
      if (lift > 0.0)
        EXPECT_FALSE(sweep.touches(raised - side, raised + side, Vector3d::UnitZ(), 0.5 * lift)) << angle << ' ' << lift;
    }
  }
}

} // namespace mesh_sweep_test
