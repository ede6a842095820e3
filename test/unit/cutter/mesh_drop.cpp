// SPDX-License-Identifier: BSD-3-Clause
// Cutters moved down onto meshes, against all triangles one by one.
#include "cutter/mesh_drop.h"

#include "support/plain_mesh.h"
#include "support/searched_triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesh_drop_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double as_they_are = std::numeric_limits<double>::infinity();

Matrix3d
seenBy(const AxisFrame& frame, const Matrix3d& corners)
{
  Matrix3d seen;
  for (int k = 0; k < 3; ++k)
    seen.col(k) << frame.across(corners.col(k)), frame.along(corners.col(k));
  return seen;
}

/** The patch of each face, divided into quarters until none sags by more than \p sag: flat triangles. */
void
cutUp(const PatchCell& cell, double sag, std::vector<Matrix3d>& triangles)
{
  if (!(cell.sag() > sag))
    triangles.push_back(cell.corners);
  else
    for (int k = 0; k < 4; ++k)
      cutUp(cell.quarter(k), sag, triangles);
}

double
wavy(double x, double y)
{
  return 3.0 * std::sin(x / 4.0) + 2.0 * std::cos(y / 5.0 + x / 9.0);
}

AxisFrame
randomFrame(double half, double lean, Random& random)
{
  const Vector3d through(random.uniform(-half, half), random.uniform(-half, half), random.uniform(-5, 5));
  const Vector3d side(random.normal(), random.normal(), 0.0);
  return {through, (Vector3d::UnitZ() + std::tan(lean * random.uniform(0.0, 1.0)) * side.normalized()).normalized()};
}

/** The greatest height over all triangles. */
TouchedTriangle
highestOf(const std::vector<Matrix3d>& triangles, const CutterProfile& cutter, const AxisFrame& frame)
{
  const TriangleTouch touch(cutter);
  TouchedTriangle best;
  for (const Matrix3d& triangle : triangles) {
    const TouchedTriangle one = touch.touch(seenBy(frame, triangle));
    if (one.found && (!best.found || one.height > best.height))
      best = one;
  }
  return best;
}

} // namespace

TEST(MeshDrop, OnFlatTrianglesIsTheHighestOfAll)
{
  Random random(3);
  PlainMesh soup;
  for (std::uint32_t i = 0; i < 10000; ++i) {
    const Matrix3d c = randomTriangle(3.0, random);
    const Vector3d shift(random.uniform(-40, 40), random.uniform(-40, 40), 0.0);
    for (int k = 0; k < 3; ++k)
      soup.corners.push_back(c.col(k) + shift);
    soup.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const SurfaceMesh::ConstPtr mesh = soup.surface();
  const PatchTree faces = facesOf(*mesh);
  std::vector<Matrix3d> triangles;
  for (std::size_t t = 0; t < mesh->faceCount(); ++t)
    triangles.push_back(mesh->patch(t).corners);
  for (int i = 0; i < 500; ++i) {
    const CutterProfile cutter(randomCutter(random));
    const AxisFrame frame = randomFrame(50.0, 1.4, random);
    const MeshDrop drop(faces, cutter, as_they_are);
    const MeshContact contact = drop.highest(frame);
    const TouchedTriangle expected = highestOf(triangles, cutter, frame);
    ASSERT_EQ(contact.found, expected.found) << i;
    if (!contact.found)
      continue;
    ASSERT_NEAR(contact.height, expected.height, 1e-9) << i;
    ASSERT_NEAR(contact.height, searched(seenBy(frame, triangles[contact.face]), cutter, 1e8), 1e-6);
    ASSERT_LT((triangles[contact.face] * contact.weights - contact.contact).norm(), 1e-9);
    EXPECT_FALSE(drop.highest(frame, contact.height + 1e-6).found);
    EXPECT_EQ(drop.highest(frame, contact.height - 1e-6).height, contact.height);
  }
}

TEST(MeshDrop, OnCurvedTrianglesIsTheHighestOfTheirParts)
{
  Random random(4);
  const SurfaceMesh::ConstPtr mesh = graphMesh(wavy, 20.0, 2.5).surface();
  const PatchTree faces = facesOf(*mesh);
  constexpr double sag = 1e-3;
  std::vector<Matrix3d> triangles;
  for (std::size_t i = 0; i < faces.size(); ++i)
    cutUp(faces.cell(i), sag, triangles);
  EXPECT_GT(triangles.size(), 10 * faces.size());
  for (int i = 0; i < 60; ++i) {
    const CutterProfile cutter(randomCutter(random));
    const AxisFrame frame = randomFrame(22.0, 0.8, random);
    const MeshContact contact = MeshDrop(faces, cutter, sag).highest(frame);
    const TouchedTriangle expected = highestOf(triangles, cutter, frame);
    ASSERT_EQ(contact.found, expected.found);
    if (!contact.found)
      continue;
    ASSERT_NEAR(contact.height, expected.height, 1e-9) << i;
    const MeshPatch patch = mesh->patch(contact.face);
    ASSERT_LT((patch.position(contact.weights) - contact.contact).norm(), 1e-9);
  }
}

TEST(MeshDrop, MovesWithTheMesh)
{
  Random random(5);
  const PlainMesh plain = graphMesh(wavy, 20.0, 1.0);
  const PatchTree still = facesOf(*plain.surface());
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Eigen::Isometry3d motion = randomMotion(seed, 50.0);
    PlainMesh moved = plain;
    for (Vector3d& p : moved.corners)
      p = motion * p.cast<float>().cast<double>();
    const PatchTree faces = facesOf(*moved.surface());
    for (int i = 0; i < 100; ++i) {
      const CutterProfile cutter(CutterShape::ball(random.uniform(0.5, 6.0)));
      const AxisFrame frame = randomFrame(14.0, 0.5, random);
      const MeshContact a = MeshDrop(still, cutter, 1e-4).highest(frame);
      const MeshContact b = MeshDrop(faces, cutter, 1e-4).highest({motion * frame.origin, motion.linear() * frame.axis});
      ASSERT_TRUE(a.found && b.found);
      ASSERT_NEAR(a.height, b.height, 3e-4) << seed << ' ' << i;
    }
  }
}

TEST(MeshDrop, OrderOfFacesChangesNothing)
{
  Random random(6);
  const PlainMesh plain = graphMesh(wavy, 20.0, 1.0);
  PlainMesh other = plain;
  const std::vector<std::size_t> order = shuffled(plain.faces.size(), 7);
  for (std::size_t i = 0; i < order.size(); ++i)
    other.faces[i] = plain.faces[order[i]];
  const SurfaceMesh::ConstPtr first = plain.surface(), second = other.surface();
  const PatchTree a = facesOf(*first), b = facesOf(*second);
  for (int i = 0; i < 300; ++i) {
    const CutterProfile cutter(randomCutter(random));
    const AxisFrame frame = randomFrame(20.0, 0.8, random);
    const MeshContact one = MeshDrop(a, cutter, 1e-4).highest(frame), two = MeshDrop(b, cutter, 1e-4).highest(frame);
    ASSERT_EQ(one.found, two.found);
    if (one.found)
      ASSERT_NEAR(one.height, two.height, 1e-7);
  }
}

TEST(MeshDrop, AsHighOnTwoFacesIsThatOfTheLowerIndex)
{
  PlainMesh plain;
  plain.addQuad({-9, -9, 1}, {9, -9, 1}, {9, 9, 1}, {-9, 9, 1});
  const PatchTree faces = facesOf(*plain.surface());
  for (const double x : {-2.0, 0.0, 2.0}) {
    const MeshContact contact = MeshDrop(faces, CutterProfile(CutterShape::flatEnd(6.0)), 1e-4).highest({{x, -x, 7.0}, Vector3d::UnitZ()});
    ASSERT_TRUE(contact.found);
    EXPECT_EQ(contact.face, 0u) << x;
    EXPECT_NEAR(contact.height, -6.0, 1e-12);
  }
}

TEST(PatchTree, FindsTheNearestPlace)
{
  Random random(8);
  const PatchTree faces = facesOf(*graphMesh(wavy, 10.0, 2.5).surface());
  constexpr double sag = 1e-2;
  std::vector<Matrix3d> triangles;
  for (std::size_t i = 0; i < faces.size(); ++i)
    cutUp(faces.cell(i), sag, triangles);
  for (int i = 0; i < 20; ++i) {
    const Vector3d p(random.uniform(-11, 11), random.uniform(-11, 11), random.uniform(-6, 6));
    double expected = as_they_are;
    for (const Matrix3d& t : triangles)
      expected = std::min(expected, -largest([&](double u) {
                            const Vector3d a = (1.0 - u) * t.col(0) + u * t.col(1), b = (1.0 - u) * t.col(0) + u * t.col(2);
                            return largest([&](double w) { return -((1.0 - w) * a + w * b - p).norm(); });
                          }));
    PatchPlace place;
    ASSERT_TRUE(faces.nearest(p, 100.0, sag, place));
    ASSERT_NEAR(place.distance, expected, 1e-7);
    EXPECT_NEAR((place.position - p).norm(), place.distance, 2.0 * sag);
    PatchPlace none;
    EXPECT_FALSE(faces.nearest(p, 0.999 * place.distance, sag, none));
  }
}

} // namespace mesh_drop_test
