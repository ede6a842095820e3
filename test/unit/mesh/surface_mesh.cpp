// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/mesh/surface_mesh.h>

#include "support/mesh_surfaces.h"
#include "support/sampling.h"
#include "support/solids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace surface_mesh_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

SurfaceMesh::ConstPtr
made(const TriangleMesh& mesh, const MeshSettings& settings = {})
{
  SurfaceMesh::ConstPtr result;
  const Status status = SurfaceMesh::make(*mesh.polygons(), settings, result);
  EXPECT_TRUE(status.ok()) << status.message();
  return result;
}

std::string
refusal(const pcl::PolygonMesh& mesh, const MeshSettings& settings = {})
{
  SurfaceMesh::ConstPtr result;
  const Status status = SurfaceMesh::make(mesh, settings, result);
  EXPECT_FALSE(status.ok());
  EXPECT_EQ(result, nullptr);
  return status.message();
}

bool
has(const std::string& text, const std::string& words)
{
  return text.find(words) != std::string::npos;
}

} // namespace

TEST(SurfaceMesh, WeldsTheCornersOfAnStlFile)
{
  const TriangleMesh mesh = gridMesh(*landform(), {100, 100}, 20);
  const auto surface = made(unwelded(mesh));
  EXPECT_EQ(surface->vertexCount(), mesh.vertices.size());
  EXPECT_EQ(surface->report().welded.count, 3 * mesh.faces.size() - mesh.vertices.size());
  EXPECT_EQ(surface->report().open_edges.count, 80u);
  EXPECT_EQ(surface->report().loops, 1u);
  EXPECT_EQ(surface->report().parts, 1u);
  EXPECT_FALSE(surface->report().closed);
}

TEST(SurfaceMesh, CountsPlantedFaults)
{
  TriangleMesh mesh = unwelded(icoSphere(50.0, 3));
  const std::size_t faces = mesh.faces.size();
  const Vector3d at = mesh.vertices[mesh.faces[100][0]];
  std::swap(mesh.faces[100][1], mesh.faces[100][2]);                            // flipped
  std::swap(mesh.faces[777][1], mesh.faces[777][2]);                            // flipped
  mesh.faces.push_back(mesh.faces[5]);                                          // repeated
  mesh.faces.push_back({mesh.faces[6][1], mesh.faces[6][0], mesh.faces[6][2]}); // repeated with the opposite order
  mesh.faces.push_back({mesh.faces[7][0], mesh.faces[7][0], mesh.faces[7][1]}); // a corner twice
  mesh.vertices.push_back(0.5 * (mesh.vertices[mesh.faces[8][0]] + mesh.vertices[mesh.faces[8][1]]));
  mesh.faces.push_back({mesh.faces[8][0], mesh.faces[8][0], static_cast<std::uint32_t>(mesh.vertices.size() - 1)});
  const auto surface = made(mesh);
  const MeshReport& counts = surface->report();
  EXPECT_EQ(counts.given_faces, faces + 4);
  EXPECT_EQ(counts.faces, faces);
  EXPECT_EQ(counts.turned.count, 2u);
  EXPECT_LT((counts.turned.place - at).norm(), 1e-4);
  EXPECT_EQ(counts.repeated.count, 2u);
  EXPECT_EQ(counts.without_area.count, 2u);
  EXPECT_EQ(counts.crowded_edges.count, 0u);
  EXPECT_TRUE(counts.closed);
  EXPECT_FALSE(counts.inside_out);
}

TEST(SurfaceMesh, FindsCrowdedEdgesPartsAndLoops)
{
  TriangleMesh mesh = gridMesh(*flat(Region({rectangle(10, 10, {5, 5})})), {10, 10}, 10);
  const auto fin = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back({5.5, 5.0, 3.0}); // a third face at the edge from (5, 5) to (6, 5)
  mesh.faces.push_back({5 * 11 + 5, 5 * 11 + 6, fin});
  const auto surface = made(mesh);
  EXPECT_EQ(surface->report().crowded_edges.count, 1u);
  EXPECT_LT((surface->report().crowded_edges.place - Vector3d(5.5, 5.0, 0.0)).norm(), 1e-6);
  EXPECT_EQ(surface->report().parts, 2u);
  EXPECT_EQ(surface->faceCount(), mesh.faces.size());
}

TEST(SurfaceMesh, TurnsAClosedMeshInsideOut)
{
  TriangleMesh mesh = icoSphere(10.0, 2);
  for (auto& f : mesh.faces)
    std::swap(f[1], f[2]);
  const auto surface = made(mesh);
  EXPECT_TRUE(surface->report().inside_out);
  for (std::size_t t = 0; t < surface->faceCount(); ++t)
    ASSERT_GT(surface->faceNormal(t).dot(surface->position(surface->triangles().triangle(t)[0])), 0.0);
  MeshSettings flipped;
  flipped.flip = true;
  EXPECT_LT(made(mesh, flipped)->faceNormal(0).dot(made(mesh, flipped)->position(made(mesh, flipped)->triangles().triangle(0)[0])), 0.0);
}

TEST(SurfaceMesh, TurnsAMeshInsideOutWithAMissingFaceOrASliver)
{
  TriangleMesh missing = icoSphere(10.0, 2);
  for (auto& f : missing.faces)
    std::swap(f[1], f[2]);
  TriangleMesh sliver = missing;
  missing.faces.erase(missing.faces.begin() + 17);
  missing.faces.erase(missing.faces.begin() + 100);
  EXPECT_TRUE(made(missing)->report().inside_out);
  EXPECT_FALSE(made(missing)->report().closed);
  // One face becomes two, and a face without area joins the new corner to its edge.
  const auto whole = sliver.faces[40];
  const auto middle = static_cast<std::uint32_t>(sliver.vertices.size());
  sliver.vertices.push_back(0.5 * (sliver.vertices[whole[0]] + sliver.vertices[whole[1]]));
  sliver.faces[40] = {whole[0], middle, whole[2]};
  sliver.faces.push_back({middle, whole[1], whole[2]});
  sliver.faces.push_back({whole[0], whole[1], middle});
  const auto surface = made(sliver);
  EXPECT_TRUE(surface->report().inside_out);
  for (std::size_t t = 0; t < surface->faceCount(); ++t)
    if (surface->faceArea(t) > 1e-3) // not the sliver
      ASSERT_GT(surface->faceNormal(t).dot(surface->position(surface->triangles().triangle(t)[0])), 0.0);
}

TEST(SurfaceMesh, LeavesTheSideOfAnOpenSheet)
{
  TriangleMesh half = icoSphere(10.0, 3), outer = half;
  for (auto& f : half.faces)
    std::swap(f[1], f[2]);
  const auto isLow = [&](const auto& f) { return half.vertices[f[0]].z() + half.vertices[f[1]].z() + half.vertices[f[2]].z() < -20.0; };
  half.faces.erase(std::remove_if(half.faces.begin(), half.faces.end(), isLow), half.faces.end()); // a round pot, to be cut inside
  EXPECT_FALSE(made(half)->report().inside_out);
  outer.faces.erase(outer.faces.begin());
  EXPECT_FALSE(made(outer)->report().inside_out);
}

TEST(SurfaceMesh, OfASphereIsRoundAndItsNormalsExact)
{
  const auto surface = made(icoSphere(50.0, 3));
  double plain = 0.0, curved = 0.0;
  Random random(3);
  for (std::size_t t = 0; t < surface->faceCount(); ++t) {
    const MeshPatch patch = surface->patch(t);
    for (int k = 0; k < 3; ++k)
      ASSERT_LT((patch.normals.col(k) - patch.corners.col(k).normalized()).norm(), 1e-3);
    double a = random.uniform(), b = random.uniform();
    if (a + b > 1.0) {
      a = 1.0 - a;
      b = 1.0 - b;
    }
    const Vector3d share(a, b, 1.0 - a - b);
    plain = std::max(plain, std::abs((patch.corners * share).norm() - 50.0));
    curved = std::max(curved, std::abs(patch.position(share).norm() - 50.0));
    ASSERT_LE((patch.corners * share - patch.position(share)).norm(), surface->sag(t) + 1e-12);
    ASSERT_LT((patch.normal(share) - patch.position(share).normalized()).norm(), 3e-3);
  }
  EXPECT_GT(plain, 0.1);
  EXPECT_LT(curved, 0.02 * plain);
}

TEST(SurfaceMesh, OfACubeIsFlatAndOfACylinderRound)
{
  const auto box = made(cube(20.0));
  EXPECT_EQ(box->report().creases.count, 12u);
  EXPECT_NEAR(box->report().crease_length, 240.0, 1e-4);
  for (std::size_t t = 0; t < box->faceCount(); ++t)
    ASSERT_EQ(box->sag(t), 0.0);
  const auto round = made(closedCylinder(20.0, 30.0, 64));
  EXPECT_EQ(round->report().creases.count, 128u);
  double worst = 0.0;
  for (std::size_t t = 0; t < round->faceCount(); ++t) {
    if (std::abs(round->faceNormal(t).z()) > 0.5)
      continue;
    const MeshPatch patch = round->patch(t);
    for (double a = 0.0; a <= 1.0; a += 0.125)
      for (double b = 0.0; a + b <= 1.0; b += 0.125)
        worst = std::max(worst, std::abs(patch.position({a, b, 1.0 - a - b}).head<2>().norm() - 20.0));
  }
  EXPECT_LT(worst, 5e-5); // plain: 0.024
}

TEST(SurfaceMesh, IsTheSameWhateverTheOrderOfItsFaces)
{
  const TriangleMesh mesh = gridMesh(*landform(), {100, 100}, 30, 0.3);
  TriangleMesh other = mesh;
  std::reverse(other.faces.begin(), other.faces.end());
  for (auto& f : other.faces)
    std::rotate(f.begin(), f.begin() + 1, f.end());
  const auto a = made(mesh), b = made(other);
  const std::size_t last = mesh.faces.size() - 1;
  for (std::size_t t = 0; t <= last; ++t) {
    const MeshPatch p = a->patch(t), q = b->patch(last - t);
    const Vector3d share(0.2, 0.3, 0.5), turned(0.3, 0.5, 0.2);
    ASSERT_LT((p.position(share) - q.position(turned)).norm(), 1e-9);
  }
}

TEST(SurfaceMesh, RefusesWhatIsNoMesh)
{
  pcl::PolygonMesh empty;
  EXPECT_TRUE(has(refusal(empty), "no points")) << refusal(empty);
  pcl::PolygonMesh::Ptr mesh = cube(10.0).polygons();
  mesh->polygons.clear();
  EXPECT_TRUE(has(refusal(*mesh), "no faces")) << refusal(*mesh);
  mesh = cube(10.0).polygons();
  mesh->polygons[3].vertices[1] = 8;
  EXPECT_TRUE(has(refusal(*mesh), "face 3 has the corner 8")) << refusal(*mesh);
  mesh = cube(10.0).polygons();
  mesh->polygons[2].vertices.resize(2);
  EXPECT_TRUE(has(refusal(*mesh), "face 2 has 2 corners")) << refusal(*mesh);
  TriangleMesh broken = cube(10.0);
  broken.vertices[5].x() = NAN;
  EXPECT_TRUE(has(refusal(*broken.polygons()), "corner 5 of face")) << refusal(*broken.polygons());
  TriangleMesh line = cube(10.0);
  for (Vector3d& v : line.vertices)
    v.tail<2>().setZero();
  EXPECT_TRUE(has(refusal(*line.polygons()), "none of the 12 faces has an area")) << refusal(*line.polygons());
  MeshSettings settings;
  settings.crease_angle = 0.0;
  EXPECT_TRUE(has(refusal(*cube(10.0).polygons(), settings), "setCreaseAngle"));
}

} // namespace surface_mesh_test
