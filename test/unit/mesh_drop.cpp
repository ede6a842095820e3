// Cutters brought down on triangles and meshes, against search in two dimensions and against all triangles one by one.
#include <pcl_spiral/toolpath/mesh_drop.h>

#include "support/cutters.h"
#include "support/plain_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double as_they_are = std::numeric_limits<double>::infinity();

/** The largest of a concave function on [0, 1]. */
template <typename Function>
double
largest(const Function& f)
{
  constexpr double golden = 0.6180339887498949;
  double a = 0.0, b = 1.0, x = 1.0 - golden, y = golden, fx = f(x), fy = f(y);
  double best = std::max({f(0.0), f(1.0), fx, fy});
  for (int i = 0; i < 70; ++i) {
    if (fx < fy) {
      a = x, x = y, fx = fy;
      y = a + golden * (b - a), fy = f(y);
    }
    else {
      b = y, y = x, fy = fx;
      x = b - golden * (b - a), fx = f(x);
    }
    best = std::max({best, fx, fy});
  }
  return best;
}

/** Height at which the cutter stands on a triangle seen along its axis, by golden section within golden section; beyond the
 *  cutter the profile rises steeply instead of ending. */
double
searched(const Matrix3d& c, const CutterProfile& cutter, double steep)
{
  const double R = cutter.radius();
  return largest([&](double t) {
    const Vector3d a = (1.0 - t) * c.col(0) + t * c.col(1), b = (1.0 - t) * c.col(0) + t * c.col(2);
    return largest([&](double u) {
      const Vector3d p = (1.0 - u) * a + u * b;
      const double l = p.head<2>().norm();
      return p.z() - cutter.height(std::min(l, R)) - steep * std::max(0.0, l - R);
    });
  });
}

/** Corners at random about a cutter of radius \p R: of any size, some level, upright, thin, or about the axis. */
Matrix3d
randomTriangle(double R, Random& random)
{
  const double size = R * std::pow(10.0, random.uniform(-2.0, 0.7));
  Vector3d middle(random.uniform(-1.2, 1.2) * R, random.uniform(-1.2, 1.2) * R, random.uniform(-5.0, 5.0));
  const auto kind = random.below(8);
  if (kind == 0)
    middle.head<2>().setZero();
  Matrix3d c;
  for (int k = 0; k < 3; ++k)
    c.col(k) = middle + size * Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  if (kind == 1)
    c.row(2).setConstant(middle.z());
  if (kind == 2)
    c.row(1).setConstant(middle.y());
  if (kind == 3)
    c.col(2).head<2>() = c.col(1).head<2>();
  if (kind == 4)
    c.col(2) = 0.5 * (c.col(0) + c.col(1)) + 1e-4 * size * Vector3d(0.3, -0.8, 0.5);
  return c;
}

Matrix3d
seenBy(const AxisFrame& frame, const Matrix3d& corners)
{
  Matrix3d seen;
  for (int k = 0; k < 3; ++k)
    seen.col(k) << frame.across(corners.col(k)), frame.along(corners.col(k));
  return seen;
}

/** The patch of each face, its quarters, theirs, until none sags by more than \p sag: flat triangles. */
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

/** The highest of all triangles. */
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

TEST(TriangleTouch, IsTheHighestPlaceOfTheTriangle)
{
  Random random(1);
  std::size_t touched = 0;
  for (int i = 0; touched < 10000; ++i) {
    const CutterProfile cutter(randomCutter(random));
    const Matrix3d c = randomTriangle(cutter.radius(), random);
    const TouchedTriangle t = TriangleTouch(cutter).touch(c);
    constexpr double steep = 1e8;
    const double expected = searched(c, cutter, steep);
    if (expected < -1e5 || !t.found) { // beyond the cutter, or by less than a thousandth of a micrometre
      EXPECT_TRUE(!t.found || expected > -1e5) << i;
      EXPECT_TRUE(t.found || expected < 50.0 - 1e-9 * steep) << i << ' ' << expected;
      continue;
    }
    ++touched;
    ASSERT_NEAR(t.height, expected, 1e-6) << i << '\n' << c;
    ASSERT_NEAR(t.weights.sum(), 1.0, 1e-12);
    ASSERT_GE(t.weights.minCoeff(), 0.0);
    const Vector3d p = c * t.weights;
    ASSERT_LE(p.head<2>().norm(), cutter.radius() * (1.0 + 1e-9));
  }
}

TEST(TriangleTouch, AWiderCutterIsTheOneOfSoMuchMoreRadius)
{
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    CutterShape shape = randomCutter(random);
    const CutterProfile cutter(shape);
    const Matrix3d c = randomTriangle(shape.radius, random);
    const double wider = random.uniform(0.0, 1.0);
    shape.radius += wider;
    const TouchedTriangle a = TriangleTouch(cutter).touch(c, wider), b = TriangleTouch(CutterProfile(shape)).touch(c);
    ASSERT_EQ(a.found, b.found);
    if (a.found)
      ASSERT_NEAR(a.height, b.height, 1e-7) << i;
  }
}

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
    const MeshContact contact =
        MeshDrop(faces, CutterProfile(CutterShape::flatEnd(6.0)), 1e-4).highest({{x, -x, 7.0}, Vector3d::UnitZ()});
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
