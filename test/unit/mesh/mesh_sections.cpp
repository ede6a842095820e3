// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/mesh/mesh_sections.h>

#include "support/mesh_surfaces.h"
#include "support/sampling.h"
#include "support/solids.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkCutter.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace mesh_sections_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

DrivePasses
passesOf(MeshSections& sections)
{
  DrivePasses passes;
  sections.compute(passes);
  EXPECT_TRUE(sections.getStatus().ok()) << sections.getStatus().message();
  return passes;
}

/** Plain sections: straight edges, no points inside faces. */
void
setPlain(MeshSections& sections)
{
  sections.setEdges(MeshEdges::Straight);
  sections.setChordError(1e6);
}

std::vector<Vector3d>
cutByVtk(const pcl::PolygonMesh& mesh, const Vector3d& normal, double level)
{
  SurfaceMesh::ConstPtr surface; // welded, like the plain lines
  EXPECT_TRUE(SurfaceMesh::make(mesh, {}, surface).ok());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t v = 0; v < surface->vertexCount(); ++v)
    points->InsertNextPoint(surface->position(v).data());
  vtkNew<vtkCellArray> cells;
  for (std::size_t t = 0; t < surface->faceCount(); ++t) {
    const auto& f = surface->triangles().triangle(t);
    const vtkIdType corners[3] = {f[0], f[1], f[2]};
    cells->InsertNextCell(3, corners);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  vtkNew<vtkPlane> plane;
  const Vector3d origin = normal * level;
  plane->SetNormal(normal.x(), normal.y(), normal.z());
  plane->SetOrigin(origin.x(), origin.y(), origin.z());
  vtkNew<vtkCutter> cutter;
  cutter->SetInputData(data);
  cutter->SetCutFunction(plane);
  cutter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  cutter->Update();
  std::vector<Vector3d> found;
  for (vtkIdType i = 0; i < cutter->GetOutput()->GetNumberOfPoints(); ++i)
    found.emplace_back(cutter->GetOutput()->GetPoint(i));
  return found;
}

/** Largest distance from a point of \p these to the nearest of \p those. */
double
farthest(const std::vector<Vector3d>& these, const std::vector<Vector3d>& those)
{
  double most = 0.0;
  for (const Vector3d& p : these) {
    double least = INFINITY;
    for (const Vector3d& q : those)
      least = std::min(least, (p - q).norm());
    most = std::max(most, least);
  }
  return most;
}

std::vector<Vector3d>
placesOf(const DrivePasses& passes)
{
  std::vector<Vector3d> places;
  for (const DrivePass& pass : passes)
    for (const DrivePoint& p : pass.points)
      places.push_back(p.position);
  return places;
}

void
expectSame(const DrivePasses& a, const DrivePasses& b, double tolerance = 0.0)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].closed, b[i].closed);
    ASSERT_EQ(a[i].points.size(), b[i].points.size());
    for (std::size_t k = 0; k < a[i].points.size(); ++k) {
      ASSERT_LE((a[i].points[k].position - b[i].points[k].position).norm(), tolerance) << i << " " << k;
      ASSERT_LE((a[i].points[k].normal - b[i].points[k].normal).norm(), tolerance);
    }
  }
}

} // namespace

TEST(MeshSections, PlainLinesAreThoseOfVtk)
{
  const Vector3d normals[] = {Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ(), Vector3d(0.3, -0.7, 0.5).normalized()};
  for (const TriangleMesh& mesh : {gridMesh(*landform(), {100, 100}, 40, 0.3), icoSphere(30.0, 3)})
    for (const Vector3d& normal : normals) {
      const pcl::PolygonMesh::Ptr polygons = mesh.polygons();
      MeshSections sections;
      sections.setInputMesh(polygons);
      setPlain(sections);
      sections.setPlaneNormal(normal);
      double low = INFINITY, high = -INFINITY;
      for (const Vector3d& v : mesh.vertices) {
        low = std::min(low, normal.dot(v));
        high = std::max(high, normal.dot(v));
      }
      for (const double share : {0.1, 0.37, 0.5, 0.83}) {
        const double level = low + share * (high - low);
        sections.setLevels({level});
        const std::vector<Vector3d> ours = placesOf(passesOf(sections)), theirs = cutByVtk(*polygons, normal, level);
        ASSERT_GT(ours.size(), 10u);
        EXPECT_LT(farthest(ours, theirs), 1e-6);
        EXPECT_LT(farthest(theirs, ours), 1e-6);
      }
    }
}

TEST(MeshSections, AllSearchesGiveTheSameLines)
{
  const pcl::PolygonMesh::Ptr mesh = gridMesh(*landform(), {100, 100}, 49, 0.3).polygons();
  for (const Vector3d& normal : {Vector3d(0.0, 1.0, 0.0), Vector3d(0.0, 0.0, 1.0), Vector3d(1.0, 2.0, 0.1)}) {
    MeshSections sections;
    sections.setInputMesh(mesh);
    sections.setPlaneNormal(normal);
    sections.setStepOver(0.7);
    const DrivePasses lines = passesOf(sections);
    const std::size_t crossings = sections.getReport().crossings;
    for (const MeshSearch search : {MeshSearch::RTree, MeshSearch::AllFaces}) {
      sections.setSearch(search);
      expectSame(passesOf(sections), lines);
      EXPECT_EQ(sections.getReport().crossings, crossings);
    }
    sections.setSearch(MeshSearch::LevelLines);
    for (const unsigned int threads : {1u, 3u}) {
      sections.setNumberOfThreads(threads);
      expectSame(passesOf(sections), lines);
    }
  }
}

TEST(MeshSections, OfACubeAreExactAndTurnAtItsEdges)
{
  MeshSections sections;
  sections.setInputMesh(cube(20.0).polygons());
  sections.setStepOver(3.0);
  const DrivePasses passes = passesOf(sections);
  ASSERT_EQ(passes.size(), 7u);
  for (const DrivePass& pass : passes) {
    EXPECT_TRUE(pass.closed);
    double length = 0.0;
    for (std::size_t i = 0; i < pass.points.size(); ++i) {
      const Vector3d &p = pass.points[i].position, &n = pass.points[i].normal;
      length += (pass.points[(i + 1) % pass.points.size()].position - p).norm();
      const double off = std::min({std::abs(p.x()), std::abs(p.x() - 20.0), std::abs(p.z()), std::abs(p.z() - 20.0)});
      EXPECT_LT(off, 1e-6);
      EXPECT_NEAR(n.cwiseAbs().maxCoeff(), 1.0, 1e-12); // no blend across an edge
    }
    EXPECT_NEAR(length, 80.0, 1e-6);
  }
  // At each of the four edges the contact comes with the normals of both sides.
  std::size_t turns = 0;
  for (std::size_t i = 0; i + 1 < passes[0].points.size(); ++i)
    turns += (passes[0].points[i].position - passes[0].points[i + 1].position).norm() < 1e-9;
  EXPECT_GE(turns, 3u);
}

TEST(MeshSections, OfACylinderLieOnItsWall)
{
  MeshSections sections;
  sections.setInputMesh(closedCylinder(20.0, 30.0, 64).polygons());
  for (const Vector3d& normal : {Vector3d(0.0, 0.0, 1.0), Vector3d(0.3, 0.1, 1.0)}) {
    sections.setPlaneNormal(normal);
    sections.setStepOver(2.0);
    sections.setChordError(0.001);
    double worst = 0.0;
    for (const DrivePass& pass : passesOf(sections))
      for (const DrivePoint& p : pass.points)
        if (std::abs(p.normal.z()) < 0.5)
          worst = std::max(worst, std::abs(p.position.head<2>().norm() - 20.0));
    EXPECT_LT(worst, 5e-5); // plain: 0.024
  }
}

TEST(MeshSections, KeepTheChordErrorInsideFaces)
{
  // A coarse sphere: its faces sag by 0.4 mm.
  MeshSections sections;
  sections.setInputMesh(icoSphere(50.0, 2).polygons());
  sections.setStepOver(2.0);
  std::size_t before = 0;
  for (const double error : {0.1, 0.01, 0.001}) {
    sections.setChordError(error);
    double worst = 0.0; // chords against the curved surface, which is within 0.005 of the sphere here
    for (const DrivePass& pass : passesOf(sections))
      for (std::size_t i = 0; i < pass.points.size(); ++i) {
        const Vector3d &a = pass.points[i].position, &b = pass.points[(i + 1) % pass.points.size()].position;
        worst = std::max(worst, std::abs((0.5 * (a + b)).norm() - 0.5 * (a.norm() + b.norm())));
      }
    EXPECT_LT(worst, 1.3 * error);
    EXPECT_GT(sections.getReport().inside_points, before);
    before = sections.getReport().inside_points;
  }
}

TEST(MeshSections, RowsFollowEachOther)
{
  MeshSections sections;
  sections.setInputMesh(gridMesh(*landform(), {100, 100}, 30).polygons());
  sections.setStepOver(5.0);
  DrivePasses passes = passesOf(sections);
  ASSERT_EQ(passes.size(), 20u);
  EXPECT_EQ(sections.getReport().rows, 20u);
  EXPECT_NEAR(sections.getReport().step_over, 5.0, 1e-9);
  for (std::size_t k = 0; k < passes.size(); ++k) {
    EXPECT_NEAR(passes[k].points.front().position.y(), 2.5 + 5.0 * k, 1e-9);
    if (k > 0)
      EXPECT_LT((passes[k].points.front().position - passes[k - 1].points.back().position).norm(), 6.0);
  }
  sections.setZigzag(false);
  passes = passesOf(sections);
  for (const DrivePass& pass : passes)
    EXPECT_GT((pass.points.back().position - pass.points.front().position)
                  .dot(passes[0].points.back().position - passes[0].points.front().position),
              0.0);
}

TEST(MeshSections, AreTheSameOnAMovedMesh)
{
  const TriangleMesh mesh = gridMesh(*landform(), {100, 100}, 30, 0.3);
  TriangleMesh moved = mesh;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  const Vector3d shift(10.0, -20.0, 5.0);
  for (Vector3d& v : moved.vertices)
    v = turn * v + shift;
  std::reverse(moved.faces.begin(), moved.faces.end());
  MeshSections sections;
  sections.setInputMesh(mesh.polygons());
  std::vector<double> levels, shifted;
  for (double level = 1.01; level < 100.0; level += 3.0) {
    levels.push_back(level);
    shifted.push_back(level + (turn * Vector3d::UnitY()).dot(shift));
  }
  sections.setLevels(levels);
  const DrivePasses here = passesOf(sections);
  sections.setInputMesh(moved.polygons());
  sections.setPlaneNormal(turn * Vector3d::UnitY());
  sections.setAxis(turn * Vector3d::UnitZ());
  sections.setLevels(shifted);
  const std::vector<Vector3d> there = placesOf(passesOf(sections));
  std::vector<Vector3d> expected;
  for (const Vector3d& p : placesOf(here))
    expected.push_back(turn * p + shift);
  EXPECT_LT(farthest(expected, there), 2e-4); // coordinates are floats, and crossings near vertices move
  EXPECT_LT(farthest(there, expected), 2e-4);
}

TEST(MeshSections, RefuseWhatTheyCannotDo)
{
  MeshSections sections;
  DrivePasses passes(3);
  const auto refused = [&](const std::string& words) {
    passes.resize(3);
    sections.compute(passes);
    EXPECT_FALSE(sections.getStatus().ok());
    EXPECT_TRUE(passes.empty());
    EXPECT_NE(sections.getStatus().message().find(words), std::string::npos) << sections.getStatus().message();
  };
  sections.setStepOver(1.0);
  refused("setInputMesh");
  sections.setInputMesh(pcl::make_shared<pcl::PolygonMesh>());
  refused("no points");
  sections.setInputMesh(cube(10.0).polygons());
  sections.setStepOver(0.0);
  refused("setStepOver");
  sections.setStepOver(1.0);
  sections.setPlaneNormal(Vector3d::Zero());
  refused("setPlaneNormal");
  sections.setPlaneNormal(Vector3d::UnitX());
  sections.setAxis(Vector3d::Zero());
  refused("setAxis");
  sections.setAxis(Vector3d::UnitZ());
  sections.setChordError(0.0);
  refused("setChordError");
  sections.setChordError(0.01);
  sections.setLevels({3.0, 2.0});
  refused("ascend");
  sections.setLevels({30.0});
  refused("no plane crosses the mesh");
  sections.setLevels({});
  sections.setStepOver(1e-9);
  refused("another unit than mm");
  sections.setStepOver(1.0);
  sections.setProgressCallback([](double, const std::string&) { return false; });
  refused("cancelled");
}

} // namespace mesh_sections_test
