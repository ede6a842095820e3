// SPDX-License-Identifier: BSD-3-Clause
// DeviationEstimation and MaterialRemoval with a mesh: exact surface, planted faults, separate creases, solids, holes, passes.
#include <pcl_spiral/verify/deviation_estimation.h>
#include <pcl_spiral/verify/material_removal.h>

#include "support/judged_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace mesh_reference_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

using Path = pcl::PointCloud<ToolpathPoint>;
using Values = pcl::PointCloud<pcl::PointXYZI>;
constexpr double R = 5.0, h = 0.02;

/** A contact on z = height(x, y), \p off along its normal; the axis +z. */
template <typename Height>
ToolpathPoint
contact(Height height, double x, double y, double off = 0.0)
{
  const Eigen::Vector3d n = heightNormal(height, x, y);
  ToolpathPoint p;
  p.getVector3fMap() = (Eigen::Vector3d(x, y, height(x, y)) + off * n).cast<float>();
  p.getNormalVector3fMap() = n.cast<float>();
  p.getAxisVector3fMap() = Eigen::Vector3f::UnitZ();
  return p;
}

/** If \p lifts, the arc length does not change where the turn, the number of the row, changes. */
void
measureRows(Path& path, bool lifts)
{
  for (std::size_t i = 0; i < path.size(); ++i)
    path[i].arc_length =
        i == 0 ? 0.0
               : path[i - 1].arc_length +
                     (lifts && path[i].turn != path[i - 1].turn ? 0.0 : (path[i].getVector3fMap() - path[i - 1].getVector3fMap()).norm());
}

/** Rows along x, or along y, \p step apart, \p along between contacts, over |x|, |y| <= half, back and forth. */
template <typename Height>
Path::Ptr
rows(Height height, double half, double step, double along, bool lifts = true, bool along_y = false)
{
  Path::Ptr path(new Path);
  const int count = static_cast<int>(std::lround(2.0 * half / step)), points = static_cast<int>(std::lround(2.0 * half / along));
  for (int row = 0; row <= count; ++row)
    for (int i = 0; i <= points; ++i) {
      const double u = (row % 2 == 0 ? 1.0 : -1.0) * half * (2.0 * i / points - 1.0), v = half * (2.0 * row / count - 1.0);
      path->push_back(along_y ? contact(height, v, u) : contact(height, u, v));
      path->back().turn = static_cast<float>(row);
    }
  measureRows(*path, lifts);
  return path;
}

DeviationReport
deviations(const pcl::PolygonMesh::ConstPtr& mesh, const Path::ConstPtr& path, double spacing = 0.0)
{
  Values output;
  DeviationEstimation<pcl::PointXYZ> judge;
  judge.setInputMesh(mesh);
  judge.setSampleSpacing(spacing);
  judge.setInputToolpath(path);
  judge.compute(output);
  EXPECT_TRUE(judge.getStatus().ok()) << judge.getStatus().message();
  return judge.getReport();
}

RemovalReport
removed(const pcl::PolygonMesh::ConstPtr& mesh, const Path::ConstPtr& path, double spacing = 0.4)
{
  Values output;
  MaterialRemoval<pcl::PointXYZ> judge;
  judge.setInputMesh(mesh);
  judge.setSampleSpacing(spacing);
  judge.setInputToolpath(path);
  judge.setToolRadius(R);
  judge.setScallopHeight(h);
  judge.compute(output);
  EXPECT_TRUE(judge.getStatus().ok()) << judge.getStatus().message();
  EXPECT_EQ(output.size(), judge.getRidgeHeights().size());
  return judge.getReport();
}

double
flat(double, double)
{
  return 0.0;
}
double
roof(double x, double)
{
  return -0.5 * std::abs(x);
}
double
valley(double x, double)
{
  return 0.5 * std::abs(x);
}

/** All warnings in one text. */
std::string
all(const pcl_spiral::Diagnostics& warnings)
{
  std::string text;
  for (const pcl_spiral::Diagnostic& warning : warnings)
    text += warning.text() + "\n";
  return text;
}

} // namespace

TEST(MeshReference, PointsOfTheCurvedFacesDeviateByNothing)
{
  const auto mesh = heightMesh(hills, 100.0, 49).made();
  SurfaceMesh::ConstPtr made;
  ASSERT_TRUE(SurfaceMesh::make(*mesh, MeshSettings(), made).ok());
  Path::Ptr path(new Path);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (std::size_t t = 0; t < made->faceCount(); ++t) {
    const double r = std::sqrt(share(random)), s = share(random);
    const Eigen::Vector3d b(1.0 - r, r * (1.0 - s), r * s), p = made->patch(t).position(b);
    if (p.head<2>().cwiseAbs().maxCoeff() > 45.9) // two faces from the rim, where normals are less accurate
      continue;
    path->push_back(contact(hills, p.x(), p.y()));
    path->back().getVector3fMap() = p.cast<float>();
  }
  const DeviationReport f = deviations(mesh, path);
  EXPECT_EQ(f.measured, path->size());
  EXPECT_LT(std::abs(f.max.value), 5e-4);
  EXPECT_LT(f.fit_noise, 1e-4);
  EXPECT_EQ(f.in_crease_band, 0u);
  EXPECT_EQ(f.noise, 0.0);
  EXPECT_TRUE(f.warnings.empty()) << all(f.warnings);
}

TEST(MeshReference, PointsOfTheSurfaceThatWasMeshedDeviateByWhatTheMeshDoes)
{
  const auto ball = [](double x, double y) { return std::sqrt(2500.0 - x * x - y * y); };
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-0.46, 0.46);
  Path::Ptr on_ball(new Path), on_land(new Path);
  for (int i = 0; i < 4000; ++i) {
    on_ball->push_back(contact(ball, 60.0 * place(random), 60.0 * place(random)));
    on_land->push_back(contact(hills, 100.0 * place(random), 100.0 * place(random)));
  }
  EXPECT_LT(std::abs(deviations(heightMesh(ball, 60.0, 30).made(), on_ball).max.value), 5e-4);     // faces of 2 mm
  EXPECT_LT(std::abs(deviations(heightMesh(hills, 100.0, 49).made(), on_land).max.value), 1.3e-3); // of 2 mm; patches: 1.1e-3
}

TEST(MeshReference, APlantedGougeIsFoundInPlaceAndDepth)
{
  const auto mesh = heightMesh(hills, 60.0, 29).made();
  const auto path = rows(hills, 27.0, 0.6, 0.5);
  const RemovalReport clean = removed(mesh, path);
  EXPECT_LT(clean.gouge.value, 0.012); // chords of half a millimetre over hills
  ToolpathPoint& p = (*path)[path->size() / 2 + 20];
  p.getVector3fMap() -= 0.05f * p.getNormalVector3fMap();
  const RemovalReport gouged = removed(mesh, path);
  EXPECT_NEAR(gouged.gouge.value, 0.05, 0.003);
  EXPECT_LT((gouged.gouge.position - p.getVector3fMap().cast<double>()).norm(), 0.5);
  const DeviationReport f = deviations(mesh, path);
  EXPECT_NEAR(f.max.value, -0.05, 1e-3);
  EXPECT_EQ(f.max.index, path->size() / 2 + 20);
}

TEST(MeshReference, PlantedStockIsFound)
{
  const auto mesh = heightMesh(hills, 60.0, 29).made();
  const auto path = rows(hills, 29.4, 0.6, 0.5);
  const RemovalReport clean = removed(mesh, path);
  EXPECT_LT(clean.scallop.max.value, 0.02);
  EXPECT_EQ(clean.stock.uncut, 0u);
  const auto gap = pcl::make_shared<Path>(); // three rows left out: a step of 2.4 mm
  for (const ToolpathPoint& p : *path)
    if (std::abs(p.y - 0.6) > 0.9f)
      gap->push_back(p);
  measureRows(*gap, true);
  const RemovalReport left = removed(mesh, gap);
  EXPECT_NEAR(left.scallop.max.value, 2.4 * 2.4 / (8 * R), 0.04);
  EXPECT_NEAR(left.scallop.max.position.y(), 0.6, 0.5);
}

TEST(MeshReference, ARowToRowLiftCutsNothing)
{
  // Two rows on the two sides of a ridge 4 mm high: the move from row to row, straight through it, is a lift.
  const auto ridge = [](double, double y) { return 4.0 * std::exp(-y * y / 30.0); };
  const auto mesh = heightMesh(ridge, 40.0, 40).made();
  for (const bool lifts : {true, false}) {
    const RemovalReport f = removed(mesh, rows(ridge, 16.0, 32.0, 1.0, lifts));
    EXPECT_EQ(f.gouge.value > 3.0, !lifts) << f.gouge.value;
    if (lifts) {
      EXPECT_LT(f.gouge.value, 0.01);
      EXPECT_NEAR(f.path_length, 64.0, 1e-3);
    }
    else
      EXPECT_NEAR(f.path_length, 96.0, 1e-3);
  }
}

TEST(MeshReference, PassesMayBeGivenBesideThePath)
{
  const auto ridge = [](double, double y) { return 4.0 * std::exp(-y * y / 30.0); };
  const auto path = rows(ridge, 16.0, 32.0, 1.0, false); // arc lengths with the move through the ridge
  MaterialRemoval<pcl::PointXYZ> judge;
  judge.setQuiet(true);
  judge.setInputMesh(heightMesh(ridge, 40.0, 40).made());
  judge.setSampleSpacing(0.5);
  judge.setToolRadius(R);
  judge.setScallopHeight(h);
  Values output;
  judge.setInputToolpath(path, {path->size() / 2});
  judge.compute(output);
  ASSERT_TRUE(judge.getStatus().ok()) << judge.getStatus().message();
  EXPECT_LT(judge.getReport().gouge.value, 0.01);
  EXPECT_NEAR(judge.getReport().path_length, 64.0, 1e-3);
  judge.setInputToolpath(path, {path->size() / 2, 3});
  judge.compute(output);
  EXPECT_EQ(judge.getStatus().code(), StatusCode::InvalidInput);
  judge.setInputToolpath(path);
  judge.compute(output);
  EXPECT_GT(judge.getReport().gouge.value, 3.0);
}

TEST(MeshReference, CreasesAreKeptApart)
{
  for (const bool hollow : {false, true}) {
    const auto height = hollow ? valley : roof;
    const auto mesh = roofMesh(40.0, hollow ? -0.5 : 0.5).made();
    Path::Ptr path(new Path); // along the crease; in the valley only places where the ball touches one side
    const Path::Ptr every = rows(height, 19.75, 0.5, 0.5, true, true);
    for (const ToolpathPoint& p : *every)
      if (!hollow || std::abs(p.x) > 2.4f)
        path->push_back(p);
    measureRows(*path, true);
    const DeviationReport d = deviations(mesh, path, 0.2);
    EXPECT_GT(d.crease_band, 0.0);
    EXPECT_EQ(d.in_crease_band > 0, !hollow);
    EXPECT_EQ(d.in_crease_band + d.measured + d.beyond_rim, path->size());
    EXPECT_LT(std::abs(d.max.value), 1e-5) << hollow;
    EXPECT_LT(d.normal_error.value, 0.01);
    if (!hollow)
      EXPECT_GT(std::abs(d.crease_max.value), 1e-3); // by the rounded fit
    const RemovalReport r = removed(mesh, path, 0.2);
    EXPECT_GT(r.crease.samples, 0u);
    EXPECT_EQ(r.crease_band, d.crease_band);
    EXPECT_LT(r.gouge.value, 1e-4);
    EXPECT_LT(r.crease_gouge.value, 1e-4);
    if (hollow) // the ball cannot reach it
      EXPECT_GT(r.crease.max.value, 0.2);
    else {
      EXPECT_LT(r.crease.max.value, 0.02);
      EXPECT_LT(r.scallop.max.value, 0.01);
    }
  }
}

TEST(MeshReference, OfASolidTheSideWithThePathIsJudged)
{
  const auto top = [](double, double) { return 10.0; };
  Path::Ptr path = rows(top, 9.0, 0.5, 0.5);
  for (ToolpathPoint& p : *path) {
    p.x += 10.0f;
    p.y += 10.0f;
  }
  const auto mesh = boxMesh({20, 20, 10}).made();
  const DeviationReport d = deviations(mesh, path);
  EXPECT_EQ(d.measured, path->size());
  EXPECT_LT(std::abs(d.max.value), 1e-5);
  EXPECT_EQ(d.in_crease_band, 0u); // the top's edges are its rim
  EXPECT_NE(all(d.warnings).find("2 of its 12 faces are judged"), std::string::npos) << all(d.warnings);
  const RemovalReport r = removed(mesh, path);
  EXPECT_NEAR(r.area, 400.0, 1.0);
  EXPECT_NEAR(r.rim_length, 80.0, 1e-6);
  EXPECT_EQ(r.stock.uncut, 0u);
  EXPECT_EQ(r.rim.uncut, 0u);
  EXPECT_LT(r.gouge.value, 1e-4);
  for (ToolpathPoint& p : *path)
    p.z += 50.0f;
  Values output;
  DeviationEstimation<pcl::PointXYZ> judge;
  judge.setQuiet(true);
  judge.setInputMesh(mesh);
  judge.setInputToolpath(path);
  judge.compute(output);
  EXPECT_EQ(judge.getStatus().code(), StatusCode::InvalidInput);
  EXPECT_NE(judge.getStatus().message().find("50"), std::string::npos) << judge.getStatus().message();
}

TEST(MeshReference, ARoundSolidIsJudgedOnTheSideOfTheCutter)
{
  MeshDraft ball; // of radius 15, by rings
  constexpr int rings = 40, around = 80;
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j < around; ++j) {
      const double a = M_PI * i / rings, b = 2 * M_PI * j / around, r = i == 0 || i == rings ? 0.0 : 15 * std::sin(a);
      ball.add(r * std::cos(b), r * std::sin(b), 15 * std::cos(a));
    }
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < around; ++j)
      ball.quad(i * around + j, (i + 1) * around + j, (i + 1) * around + (j + 1) % around, i * around + (j + 1) % around);
  const auto dome = [](double x, double y) { return std::sqrt(225.0 - x * x - y * y); };
  const auto path = rows(dome, 8.0, 0.5, 0.5);
  const DeviationReport d = deviations(ball.made(), path);
  EXPECT_EQ(d.measured, path->size());
  EXPECT_LT(std::abs(d.max.value), 1e-3);
  const RemovalReport r = removed(ball.made(), path);
  EXPECT_LT(r.area, 0.6 * 4 * M_PI * 225);
  EXPECT_GT(r.area, 0.5 * 4 * M_PI * 225);
}

TEST(MeshReference, HolesAreRimsAndNoGaps)
{
  MeshDraft draft = heightMesh(flat, 40.0, 40);
  std::vector<pcl::Vertices> kept;
  for (const pcl::Vertices& face : draft.faces) { // a hole of 4 mm that no triangle of the samples closes
    Eigen::Vector3f middle(0, 0, 0);
    for (const auto v : face.vertices)
      middle += draft.points[v].getVector3fMap() / 3.0f;
    if (middle.cwiseAbs().maxCoeff() > 2.0f)
      kept.push_back(face);
  }
  draft.faces = kept;
  const auto path = rows(flat, 17.0, 0.5, 0.5);
  const DeviationReport d = deviations(draft.made(), path);
  EXPECT_EQ(d.in_gaps, 0u);
  EXPECT_GT(d.measured, path->size() - 81);
  const RemovalReport r = removed(draft.made(), path);
  EXPECT_NEAR(r.rim_length, 160.0 + 16.0, 1e-6);
}

TEST(MeshReference, ThreadsAndTheSurfaceMeshGivenChangeNothing)
{
  const auto mesh = heightMesh(hills, 60.0, 29).made();
  const auto path = rows(hills, 27.0, 2.0, 1.0);
  Values one, two, given;
  DeviationEstimation<pcl::PointXYZ> judge;
  judge.setInputToolpath(path);
  judge.setInputMesh(mesh);
  judge.setNumberOfThreads(1);
  judge.compute(one);
  judge.setNumberOfThreads(2);
  judge.compute(two);
  judge.setInputMesh(judge.getSurfaceMesh());
  judge.compute(given);
  ASSERT_EQ(one.size(), path->size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].intensity, two[i].intensity);
    EXPECT_EQ(one[i].intensity, given[i].intensity);
  }
}

TEST(MeshReference, WhatDoesNotFitIsRefused)
{
  Values output;
  DeviationEstimation<pcl::PointXYZ> judge;
  judge.setQuiet(true);
  judge.setInputToolpath(rows(flat, 5.0, 1.0, 1.0));
  judge.setInputMesh(heightMesh(flat, 20.0, 10).made());
  judge.setViewPoint({0, 0, 100});
  judge.compute(output);
  EXPECT_EQ(judge.getStatus().code(), StatusCode::InvalidArgument);
  EXPECT_NE(judge.getStatus().message().find("setViewPoint"), std::string::npos);
  judge.clearViewPoint();
  judge.setSampleSpacing(-1.0);
  judge.compute(output);
  EXPECT_EQ(judge.getStatus().code(), StatusCode::InvalidArgument);
  judge.setSampleSpacing(0.0);
  MeshDraft points = heightMesh(flat, 20.0, 10);
  points.faces.clear();
  judge.setInputMesh(points.made());
  judge.compute(output);
  EXPECT_EQ(judge.getStatus().code(), StatusCode::InvalidInput);
  EXPECT_TRUE(output.empty());
  MeshSettings flipped;
  flipped.flip = true;
  judge.setMeshSettings(flipped);
  judge.setInputMesh(heightMesh(flat, 20.0, 10).made());
  judge.compute(output);
  EXPECT_TRUE(judge.getStatus().ok());
  EXPECT_EQ(judge.getReport().opposed, judge.getReport().points);
}

} // namespace mesh_reference_test
