// SPDX-License-Identifier: BSD-3-Clause
// Handles of triangulations: found, cut through if noise made them, refused if they belong to the part.
#include "spiral/outlines/handle_loop.h"
#include "spiral/outlines/outline_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace handle_loop_test {

using namespace pcl_spiral;
using Eigen::Vector3d;

namespace {

/** A square sheet with two square openings; a tube on the far side joins their edges: one handle. */
struct TubedSheet {
  Polyline positions;
  std::vector<Triangulation::Triangle> triangles;

  /** \p side: nodes along the sheet; the openings are \p width cells wide; the tube between them has \p rings rings. */
  TubedSheet(int side, int width, int rings)
  {
    const double step = 1.0;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        positions.emplace_back(step * x, step * y, 0.0);
    const int y0 = side / 2, xa = side / 3, xb = 2 * side / 3;
    const auto node = [side](int x, int y) { return static_cast<std::uint32_t>(y * side + x); };
    const auto open = [&](int x, int y) {
      return y >= y0 && y < y0 + width && ((x >= xa && x < xa + width) || (x >= xb && x < xb + width));
    };
    for (int y = 0; y + 1 < side; ++y)
      for (int x = 0; x + 1 < side; ++x)
        if (!open(x, y))
          addQuad(node(x, y), node(x + 1, y), node(x + 1, y + 1), node(x, y + 1));
    std::vector<std::uint32_t> a, b; // round the openings, the second mirrored
    for (int k = 0; k < 4 * width; ++k) {
      const int edge = k / width, along = k % width;
      const int dx = edge == 0 ? along : edge == 1 ? width : edge == 2 ? width - along : 0;
      const int dy = edge == 0 ? 0 : edge == 1 ? along : edge == 2 ? width : width - along;
      a.push_back(node(xa + dx, y0 + dy));
      b.push_back(node(xb + width - dx, y0 + dy));
    }
    std::vector<std::uint32_t> before = a;
    for (int r = 1; r <= rings; ++r) {
      std::vector<std::uint32_t> ring = b;
      const double share = static_cast<double>(r) / rings;
      for (std::size_t k = 0; r < rings && k < ring.size(); ++k) {
        ring[k] = static_cast<std::uint32_t>(positions.size());
        positions.push_back((1.0 - share) * positions[a[k]] + share * positions[b[k]] - Vector3d(0, 0, 3.0 * std::sin(M_PI * share)));
      }
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const std::size_t next = (k + 1) % ring.size();
        addQuad(before[k], before[next], ring[next], ring[k]);
      }
      before = ring;
    }
  }

  StepOverMesh mesh() const
  {
    StepOverMesh made;
    made.positions = positions;
    made.normals.assign(positions.size(), Eigen::Vector3f::UnitZ());
    return made;
  }
  OutlineSide rim(int side) const
  {
    BoundaryLoop loop;
    const double end = side - 1.0 + 1.0; // beyond the sheet by a spacing
    loop.curve = {{-1.0, -1.0, 0.0}, {end, -1.0, 0.0}, {end, end, 0.0}, {-1.0, end, 0.0}};
    return OutlineSide({loop});
  }

private:
  void addQuad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
  {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
};

} // namespace

TEST(HandleLoop, IsShortAndGoesRoundTheTube)
{
  const TubedSheet sheet(40, 2, 9);
  const Triangulation triangles(sheet.positions.size(), sheet.triangles);
  EXPECT_EQ(missingEuler(sheet.positions, triangles), 2u);
  const std::vector<std::uint32_t> way = handleLoop(sheet.positions, triangles);
  ASSERT_FALSE(way.empty());
  Polyline line;
  for (const std::uint32_t v : way)
    line.push_back(sheet.positions[v]);
  EXPECT_LE(length(line, true), 8.01); // round an opening of 2 by 2
}

TEST(HandleLoop, SheetsWithHolesHaveNone)
{
  const TubedSheet sheet(40, 2, 9);
  std::vector<Triangulation::Triangle> flat(sheet.triangles.begin(), sheet.triangles.begin() + 2 * (39 * 39 - 8));
  const Triangulation triangles(sheet.positions.size(), flat);
  EXPECT_EQ(triangles.boundaryLoops().size(), 3u);
  EXPECT_EQ(missingEuler(sheet.positions, triangles), 0u);
  EXPECT_TRUE(handleLoop(sheet.positions, triangles).empty());
}

TEST(HandleLoop, AHandleOfNoiseIsCutThrough)
{
  const TubedSheet sheet(40, 2, 9);
  const StepOverMesh mesh = sheet.mesh();
  Triangulation kept;
  const Status status = trianglesWithin(mesh, Triangulation(mesh.size(), sheet.triangles), sheet.rim(40), 1.0, kept);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(missingEuler(mesh.positions, kept), 0u);
  EXPECT_GT(kept.triangleCount(), sheet.triangles.size() - 60);
}

TEST(HandleLoop, AHandleOfThePartIsRefusedWithItsPlace)
{
  const TubedSheet sheet(60, 5, 20);
  const StepOverMesh mesh = sheet.mesh();
  Triangulation kept;
  const Status status = trianglesWithin(mesh, Triangulation(mesh.size(), sheet.triangles), sheet.rim(60), 1.0, kept);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.message().find("handle"), std::string::npos) << status.message();
  double x = 0.0, y = 0.0;
  ASSERT_EQ(std::sscanf(status.message().substr(status.message().find('(')).c_str(), "(%lf, %lf", &x, &y), 2) << status.message();
  EXPECT_NEAR(x, 32.5, 15.0);
  EXPECT_NEAR(y, 32.5, 4.0);
}

TEST(HandleLoop, TrianglesThatTouchInANodeAloneArePulledApart)
{
  // Two cones that share their tip: the tip is on no free edge, and is not a node of a sheet.
  Polyline positions{{0, 0, 0}};
  std::vector<Triangulation::Triangle> triangles;
  for (const double z : {1.0, -1.0}) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (int k = 0; k < 6; ++k)
      positions.emplace_back(std::cos(k * M_PI / 3.0), std::sin(k * M_PI / 3.0), z);
    for (std::uint32_t k = 0; k < 6; ++k) {
      const std::uint32_t a = first + k, b = first + (k + 1) % 6;
      triangles.push_back(z > 0.0 ? Triangulation::Triangle{0, a, b} : Triangulation::Triangle{0, b, a});
    }
  }
  for (std::uint32_t k = 0; k < 6; ++k) { // a tube round them keeps both in one part
    const std::uint32_t next = (k + 1) % 6;
    triangles.push_back({1 + k, 7 + k, 1 + next});
    triangles.push_back({1 + next, 7 + k, 7 + next});
  }
  triangles.erase(triangles.end() - 2, triangles.end());
  StepOverMesh mesh;
  mesh.positions = positions;
  mesh.normals.assign(positions.size(), Eigen::Vector3f::UnitZ());
  BoundaryLoop far;
  far.curve = {{-100, -100, 0}, {100, -100, 0}, {100, 100, 0}, {-100, 100, 0}};
  Triangulation kept;
  ASSERT_TRUE(trianglesWithin(mesh, Triangulation(mesh.size(), triangles), OutlineSide({far}), 1.0, kept).ok());
  for (std::size_t i = 0; i < kept.triangleCount(); ++i)
    for (const std::uint32_t v : kept.triangle(i))
      EXPECT_NE(v, 0u);
  EXPECT_EQ(kept.triangleCount(), 10u);
}

} // namespace handle_loop_test
