// SPDX-License-Identifier: BSD-3-Clause
// Polygons cut into triangles: the sum of their areas is that of the polygon, and no place is in two of them. The oracle
// counts how often a ray crosses the sides of the polygon.
#include <pcl_spiral/io/mesh_reader.h>

#include "support/scratch_folder.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <pcl/conversions.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace polygon_cut_test {

using namespace pcl_spiral;

namespace {

using Outline = std::vector<Eigen::Vector2d>;

double
cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

double
areaOf(const Outline& outline)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    twice += cross(outline[i], outline[(i + 1) % outline.size()]);
  return 0.5 * twice;
}

bool
inside(const Outline& outline, const Eigen::Vector2d& p)
{
  bool odd = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d a = outline[i], b = outline[(i + 1) % outline.size()];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      odd = !odd;
  }
  return odd;
}

/** Whether two sides meet, from the places where their lines meet. */
bool
crosses(const Outline& outline)
{
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if ((j + 1) % n == i)
        continue;
      Eigen::Matrix2d sides;
      sides << outline[(i + 1) % n] - outline[i], outline[j] - outline[(j + 1) % n];
      const Eigen::Vector2d along = sides.inverse() * (outline[j] - outline[i]);
      if (along.minCoeff() > 0.0 && along.maxCoeff() < 1.0)
        return true;
    }
  return false;
}

/** Reads the outline, in a tilted plane, as the only face of an OBJ file; its triangles, back in the plane. */
class PolygonCutting : public ::testing::Test {
protected:
  MeshFile readFace(const Outline& outline)
  {
    std::string text;
    char line[120];
    for (const Eigen::Vector2d& p : outline) {
      const Eigen::Vector3d q = tilt_ * Eigen::Vector3d(p.x(), p.y(), 0.0);
      std::snprintf(line, sizeof(line), "v %.9g %.9g %.9g\n", q.x(), q.y(), q.z());
      text += line;
    }
    text += "f";
    for (std::size_t i = 1; i <= outline.size(); ++i)
      text += " " + std::to_string(i);
    writeText(folder_.path("face.obj"), text + "\n");
    return readMesh(folder_.path("face.obj"));
  }

  std::vector<Outline> trianglesOf(const Outline& outline)
  {
    const MeshFile read = readFace(outline);
    EXPECT_EQ(read.polygons, outline.size() > 3 ? 1U : 0U);
    EXPECT_TRUE(read.warnings.empty()) << read.warnings[0];
    pcl::PointCloud<pcl::PointXYZ> points;
    pcl::fromPCLPointCloud2(read.mesh->cloud, points);
    std::vector<Outline> triangles;
    for (const pcl::Vertices& face : read.mesh->polygons) {
      triangles.emplace_back();
      for (const auto corner : face.vertices)
        triangles.back().push_back((tilt_.inverse() * points[static_cast<std::size_t>(corner)].getVector3fMap().cast<double>()).head<2>());
    }
    return triangles;
  }

  /** Two triangles fewer than corners, none flat, all in the sense of the outline, one over each place in it. */
  void expectCut(const Outline& outline, const std::string& name)
  {
    SCOPED_TRACE(name);
    const std::vector<Outline> triangles = trianglesOf(outline);
    ASSERT_EQ(triangles.size(), outline.size() - 2);
    const double area = areaOf(outline);
    double sum = 0.0;
    Eigen::Vector2d low = outline[0], high = outline[0];
    for (const Eigen::Vector2d& p : outline) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    for (const Outline& triangle : triangles) {
      EXPECT_GT(areaOf(triangle) / area, 0.0);
      sum += areaOf(triangle);
    }
    EXPECT_NEAR(sum / area, 1.0, 1e-5);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    int wrong = 0;
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector2d p = low + Eigen::Vector2d(share(random), share(random)).cwiseProduct(high - low);
      int over = 0;
      for (const Outline& triangle : triangles)
        over += inside(triangle, p) ? 1 : 0;
      wrong += over != (inside(outline, p) ? 1 : 0) ? 1 : 0;
    }
    EXPECT_LE(wrong, 1) << "places on a side may be taken for one beside it";
  }

  void expectBothWays(Outline outline, const std::string& name)
  {
    for (std::size_t first = 0; first < std::min<std::size_t>(outline.size(), 5); ++first) {
      expectCut(outline, name + " from corner " + std::to_string(first));
      std::rotate(outline.begin(), outline.begin() + 1, outline.end());
    }
    std::reverse(outline.begin(), outline.end());
    expectCut(outline, name + " the other way round");
  }

  ScratchFolder folder_;
  Eigen::Quaterniond tilt_ = Eigen::Quaterniond(0.8, -0.3, 0.5, 0.2).normalized();
};

/** A closed outline at these radii, at equal angles. */
Outline
around(const std::vector<double>& radii)
{
  Outline outline;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double angle = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(radii.size());
    outline.emplace_back(radii[i] * std::cos(angle), radii[i] * std::sin(angle));
  }
  return outline;
}

} // namespace

TEST_F(PolygonCutting, ConvexOnesAreFansFromTheFirstCorner)
{
  const Outline heptagon = around(std::vector<double>(7, 20.0));
  const MeshFile read = readFace(heptagon);
  ASSERT_EQ(read.mesh->polygons.size(), 5U);
  for (std::size_t t = 0; t < 5; ++t) {
    const auto& corners = read.mesh->polygons[t].vertices;
    EXPECT_EQ(corners[0], 0);
    EXPECT_EQ(corners[1], static_cast<int>(t) + 1);
    EXPECT_EQ(corners[2], static_cast<int>(t) + 2);
  }
  expectBothWays(heptagon, "heptagon");
  expectBothWays(around(std::vector<double>(500, 20.0)), "500 corners");
}

TEST_F(PolygonCutting, ConcaveOnes)
{
  expectBothWays({{0, 0}, {20, 10}, {0, 20}, {5, 10}}, "arrow");
  expectBothWays({{0, 0}, {30, 0}, {30, 10}, {20, 10}, {20, 20}, {10, 20}, {10, 10}, {0, 10}}, "T");
  Outline comb{{0, 0}, {100, 0}};
  for (int tooth = 9; tooth >= 0; --tooth)
    comb.insert(comb.end(), {{10.0 * tooth + 9.0, 40.0}, {10.0 * tooth + 0.5, 5.0}});
  expectBothWays(comb, "comb");
  Outline spiral;
  for (int i = 0; i <= 60; ++i)
    spiral.emplace_back((10.0 + i) * std::cos(0.25 * i), (10.0 + i) * std::sin(0.25 * i));
  for (int i = 60; i >= 0; --i)
    spiral.emplace_back((7.0 + i) * std::cos(0.25 * i), (7.0 + i) * std::sin(0.25 * i));
  expectBothWays(spiral, "spiral");
}

TEST_F(PolygonCutting, CornersOnStraightSidesAreNoFlatTriangles)
{
  expectBothWays({{0, 0}, {10, 0}, {20, 0}, {20, 20}}, "triangle with a corner on a side");
  expectBothWays({{0, 0}, {7, 0}, {13, 0}, {20, 0}, {20, 10}, {20, 20}, {10, 20}, {0, 20}, {0, 3}}, "square");
  Outline fine;
  for (int i = 0; i < 40; ++i)
    fine.emplace_back(0.7 * i, 0.0);
  for (int i = 0; i < 40; ++i)
    fine.emplace_back(28.0 - 0.35 * i, 0.6 * i);
  expectBothWays(fine, "triangle of 80 corners");
}

TEST_F(PolygonCutting, HolesJoinedToTheOutlineByADoubleSide)
{
  expectBothWays({{0, 0}, {30, 0}, {30, 30}, {0, 30}, {0, 0}, {10, 10}, {10, 20}, {20, 20}, {20, 10}, {10, 10}}, "frame");
  Outline ring = around(std::vector<double>(24, 40.0));
  ring.push_back(ring.front());
  const Outline hole = around(std::vector<double>(17, 22.0));
  ring.push_back(hole.front());
  ring.insert(ring.end(), hole.rbegin(), hole.rend());
  expectBothWays(ring, "ring");
}

TEST_F(PolygonCutting, RandomStars)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(5.0, 40.0);
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<double> radii(5 + static_cast<std::size_t>(trial));
    for (double& one : radii)
      one = radius(random);
    expectCut(around(radii), "star " + std::to_string(trial));
  }
}

TEST_F(PolygonCutting, RandomOnesAreCutWhereTheyDoNotCrossThemselves)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0.0, 50.0);
  int simple = 0;
  for (int trial = 0; trial < 400; ++trial) {
    Outline outline;
    for (int i = 0; i < 4 + trial % 4; ++i)
      outline.emplace_back(place(random), place(random));
    EXPECT_EQ(readFace(outline).warnings.empty(), !crosses(outline)) << trial;
    simple += crosses(outline) ? 0 : 1;
    if (!crosses(outline))
      expectCut(outline, "outline " + std::to_string(trial));
  }
  EXPECT_GT(simple, 50);
}

TEST_F(PolygonCutting, TwiceRoundIsNoConvexPolygon)
{
  Outline limacon; // every corner turns left; it goes round twice, a small loop in a large one
  for (int i = 0; i < 30; ++i)
    limacon.push_back((10.0 + 20.0 * std::cos(2.0 * M_PI * i / 30)) *
                      Eigen::Vector2d(std::cos(2.0 * M_PI * i / 30), std::sin(2.0 * M_PI * i / 30)));
  for (std::size_t first = 0; first < limacon.size(); ++first) {
    EXPECT_EQ(readFace(limacon).warnings.size(), 1U) << first;
    std::rotate(limacon.begin(), limacon.begin() + 1, limacon.end());
  }
}

TEST_F(PolygonCutting, SaysWhatCannotBeCut)
{
  for (const Outline& outline : {Outline{{0, 0}, {20, 20}, {20, 0}, {0, 20}}, Outline{{0, 0}, {10, 0}, {20, 0}, {30, 0}}}) {
    const MeshFile read = readFace(outline);
    EXPECT_EQ(read.mesh->polygons.size(), 2U);
    ASSERT_EQ(read.warnings.size(), 1U);
    EXPECT_NE(read.warnings[0].text().find("face 1 (line 5) can only be cut into triangles that overlap or are flat"), std::string::npos)
        << read.warnings[0];
  }
  std::vector<double> radii(20002, 40.0);
  for (std::size_t i = 0; i < radii.size(); i += 2)
    radii[i] = 20.0;
  try {
    readFace(around(radii));
    FAIL();
  }
  catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("face 1 (line 20003) has 20002 corners and is not convex"), std::string::npos) << error.what();
  }
}

} // namespace polygon_cut_test
