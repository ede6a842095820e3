// SPDX-License-Identifier: BSD-3-Clause
// Triangles over ridges: on the surface, as near to it as asked for, facing up, without a seam.
#include <pcl_spiral/ridge/ridge_surface.h>

#include "support/made_ridge.h"
#include "support/ridges.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace ridge_mesh_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

constexpr double degree = M_PI / 180.0;

RidgeSurface::ConstPtr
die()
{
  const ExactRidge exact = dieRidge();
  return madeRidge(exact.railPoints(300), exact.generatorPoints(0.37, 60));
}

RidgeSurface::ConstPtr
ring()
{
  const ExactRidge exact = ringRidge(
      50.0, [](double w) { return Vector3d(0.0, 24.0 * w, 16.0 * w * (1.0 - w)); }, 20.0 * degree);
  Polyline rail = exact.railPoints(315);
  rail.pop_back();
  return madeRidge(rail, exact.generatorPoints(0.2, 60));
}

RidgeSurface::ConstPtr
helix()
{
  const ExactRidge exact = helixRidge(
      100.0, 20.0 * degree, [](double w) { return Vector3d(0.0, 20.0 * w, 0.0); }, -15.0 * degree);
  return madeRidge(exact.railPoints(600), exact.generatorPoints(0.37, 41));
}

/** Distance of \p p from the ridge near (u, v), by Gauss-Newton steps. */
double
distanceFrom(const RidgeSurface& surface, const Vector3d& p, double u, double v)
{
  for (int i = 0; i < 20; ++i) {
    Eigen::Matrix<double, 3, 2> jacobian;
    jacobian << surface.alongRail(u, v), surface.alongGenerator(u, v);
    const Eigen::Vector2d step = (jacobian.transpose() * jacobian).inverse() * (jacobian.transpose() * (p - surface.position(u, v)));
    u += step.x();
    v += step.y();
  }
  return (p - surface.position(u, v)).norm();
}

struct Judged {
  double largest_vertex = 0.0, largest_face = 0.0, least_up = 1.0;
};

/** Vertices against their places, and the middles of faces and of their edges against the ridge. */
Judged
judge(const RidgeSurface& surface, const RidgeMesh& mesh)
{
  Judged judged;
  const double du = surface.rail().length() / static_cast<double>(mesh.along),
               dv = surface.generator().length() / static_cast<double>(mesh.across);
  const auto placeOf = [&](std::uint32_t vertex) {
    return Eigen::Vector2d(du * static_cast<double>(vertex / (mesh.across + 1)), dv * static_cast<double>(vertex % (mesh.across + 1)));
  };
  for (std::uint32_t k = 0; k < mesh.vertices.size(); ++k) {
    const Eigen::Vector2d at = placeOf(k);
    judged.largest_vertex = std::max(judged.largest_vertex, (mesh.vertices[k] - surface.position(at.x(), at.y())).norm());
  }
  for (std::size_t t = 0; t < mesh.faces.size(); t += 7) {
    Vector3d p[3];
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    for (int k = 0; k < 3; ++k) {
      p[k] = mesh.vertices[mesh.faces[t][k]];
      at += placeOf(mesh.faces[t][k]) / 3.0;
    }
    if (surface.rail().closed() && t + 2 * mesh.across >= mesh.faces.size())
      at.x() = surface.rail().length() - 0.5 * du; // the last cells join the first station
    judged.least_up = std::min(judged.least_up, (p[1] - p[0]).cross(p[2] - p[0]).normalized().dot(surface.normal(at.x(), at.y())));
    for (const Vector3d& b : {Vector3d(1, 1, 1), Vector3d(1.5, 1.5, 0), Vector3d(0, 1.5, 1.5), Vector3d(1.5, 0, 1.5)})
      judged.largest_face =
          std::max(judged.largest_face, distanceFrom(surface, (b[0] * p[0] + b[1] * p[1] + b[2] * p[2]) / 3.0, at.x(), at.y()));
  }
  return judged;
}

/** Number of edges with only one face. */
std::size_t
openEdges(const RidgeMesh& mesh)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& f : mesh.faces)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(++edges[std::make_pair(f[k], f[(k + 1) % 3])], 1) << "faces run the same way";
  std::size_t open = 0;
  for (const auto& [edge, count] : edges)
    open += edges.count({edge.second, edge.first}) == 0;
  return open;
}

/** Distance of curved faces from the ridge, and angle of normals, inside it and within three cells of its rims: there a normal is
 *  fitted from one side. */
void
judgeCurved(const RidgeSurface& surface)
{
  constexpr double chord_error = 0.002;
  RidgeMesh mesh;
  ASSERT_TRUE(ridgeMesh(surface, chord_error, mesh).ok());
  SurfaceMesh::ConstPtr curved;
  const Status status = ridgeMesh(surface, chord_error, curved);
  ASSERT_TRUE(status.ok()) << status.message();
  const MeshReport& counts = curved->report();
  EXPECT_EQ(counts.faces, mesh.faces.size());
  EXPECT_EQ(counts.parts, 1u);
  EXPECT_EQ(counts.creases.count + counts.turned.count + counts.welded.count, 0u);
  EXPECT_EQ(counts.loops, surface.rail().closed() ? 2u : 1u);
  EXPECT_FALSE(counts.inside_out);
  const double round = surface.rail().length(), across = surface.generator().length();
  const double du = 3.0 * round / static_cast<double>(mesh.along), dv = 3.0 * across / static_cast<double>(mesh.across);
  for (std::size_t t = 0; t < curved->faceCount(); t += 101) {
    const MeshPatch patch = curved->patch(t);
    const Vector3d middle = Vector3d::Constant(1.0 / 3.0), p = patch.position(middle);
    const double u = surface.rail().nearest(p), v = surface.generator().nearest(surface.frame(u).localOf(p - surface.rail().position(u)));
    const bool rim = (!surface.rail().closed() && (u < du || u > round - du)) || v < dv || v > across - dv;
    ASSERT_LT(distanceFrom(surface, p, u, v), rim ? 0.25 * chord_error : 2e-5) << p.transpose();
    ASSERT_LT(std::acos(std::min(1.0, patch.normal(middle).dot(surface.normal(u, v)))) / degree, rim ? 0.3 : 0.015) << p.transpose();
  }
}

} // namespace

TEST(RidgeMesh, LiesWithinTheChordErrorOfTheRidge)
{
  for (const auto& surface : {die(), ring(), helix()})
    for (const double chord_error : {0.1, 0.01, 0.002}) {
      RidgeMesh mesh;
      const Status status = ridgeMesh(*surface, chord_error, mesh);
      ASSERT_TRUE(status.ok()) << status.message();
      const Judged judged = judge(*surface, mesh);
      EXPECT_LT(judged.largest_vertex, 1e-9);
      EXPECT_LE(judged.largest_face, chord_error);
      EXPECT_GT(judged.least_up, 0.9);
      EXPECT_LE(mesh.faces.size(), 1000000u);
    }
}

TEST(RidgeMesh, IsNoFinerThanItHasToBe)
{
  for (const auto& surface : {die(), ring()}) {
    RidgeMesh mesh;
    ASSERT_TRUE(ridgeMesh(*surface, 0.002, mesh).ok());
    EXPECT_GT(judge(*surface, mesh).largest_face, 0.2 * 0.002);
  }
}

TEST(RidgeMesh, OfAClosedRailHasNoSeam)
{
  RidgeMesh mesh;
  ASSERT_TRUE(ridgeMesh(*ring(), 0.01, mesh).ok());
  EXPECT_EQ(openEdges(mesh), 2 * mesh.along);
  EXPECT_EQ(mesh.vertices.size(), mesh.along * (mesh.across + 1));
  ASSERT_TRUE(ridgeMesh(*die(), 0.01, mesh).ok());
  EXPECT_EQ(openEdges(mesh), 2 * (mesh.along + mesh.across));
}

TEST(RidgeMesh, OfAStraightRailIsFlatAlongIt)
{
  ExactRidge exact = dieRidge();
  exact.rail = [](double t) { return Vector3d(200.0 * t, 0.0, 0.0); };
  const auto surface = madeRidge(exact.railPoints(101), exact.generatorPoints(0.3, 60));
  RidgeMesh mesh;
  ASSERT_TRUE(ridgeMesh(*surface, 0.01, mesh).ok());
  const double du = surface->rail().length() / static_cast<double>(mesh.along),
               dv = surface->generator().length() / static_cast<double>(mesh.across);
  EXPECT_NEAR(du / dv, 4.0, 0.4) << "as long as a cell may be";
  EXPECT_LE(judge(*surface, mesh).largest_face, 0.01);
}

TEST(RidgeMesh, CurvedFacesAreNearerStill)
{
  for (const auto& surface : {die(), ring(), helix()})
    judgeCurved(*surface);
}

TEST(RidgeMesh, ChordErrorsThatCannotBeAreRefused)
{
  const auto surface = die();
  RidgeMesh mesh;
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const Status status = ridgeMesh(*surface, wrong, mesh);
    EXPECT_EQ(status.code(), StatusCode::InvalidArgument);
    EXPECT_NE(status.message().find("set it above 0"), std::string::npos) << status.message();
  }
  const Status status = ridgeMesh(*surface, 1e-6, mesh);
  EXPECT_EQ(status.code(), StatusCode::InvalidArgument);
  EXPECT_TRUE(mesh.faces.empty());
  const std::size_t at = status.message().find("raise it to ");
  ASSERT_NE(at, std::string::npos) << status.message();
  const Status remedied = ridgeMesh(*surface, std::stod(status.message().substr(at + 12)), mesh);
  EXPECT_TRUE(remedied.ok()) << remedied.message();
  EXPECT_GT(mesh.faces.size(), 700000u);
  SurfaceMesh::ConstPtr curved;
  EXPECT_FALSE(ridgeMesh(*surface, 0.0, curved).ok());
  EXPECT_FALSE(curved);
}

TEST(RidgeMesh, OfASlenderRidgeIsMadeInPieces)
{
  const auto slender = [](double length) {
    ExactRidge exact = dieRidge();
    exact.rail = [length](double t) { return Vector3d(length * t, 0.0, 0.0); };
    exact.generator = [](double w) { return Vector3d(0.0, w, w * (1.0 - w)); };
    return madeRidge(exact.railPoints(200), exact.generatorPoints(0.3, 40));
  };
  RidgeMesh mesh;
  const Status status = ridgeMesh(*slender(50000.0), 0.1, mesh);
  EXPECT_EQ(status.code(), StatusCode::InvalidInput);
  EXPECT_NE(status.message().find("make it in pieces"), std::string::npos) << status.message();
  const Status piece = ridgeMesh(*slender(25000.0), 0.1, mesh);
  EXPECT_TRUE(piece.ok()) << piece.message();
}

} // namespace ridge_mesh_test
