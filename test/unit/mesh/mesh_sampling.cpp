// SPDX-License-Identifier: BSD-3-Clause
// MeshSampling: the whole surface, evenly, on the patches, independent of the order in the mesh.
#include <pcl_spiral/mesh/impl/crease_lines.h>
#include <pcl_spiral/mesh/impl/mesh_rims.h>
#include <pcl_spiral/mesh/mesh_sampling.h>

#include "support/judged_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <set>

namespace mesh_sampling_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

using Samples = pcl::PointCloud<pcl::PointNormal>;

Samples
sampled(MeshSampling& sampling, double spacing)
{
  Samples samples;
  sampling.setSpacing(spacing);
  sampling.compute(samples);
  EXPECT_TRUE(sampling.getStatus().ok()) << sampling.getStatus().message();
  return samples;
}

/** Facets of 100 mm beside slivers a hundred times longer than wide, and a fan of small faces with corners on the side of
 *  a sliver that has no corners there. */
MeshDraft
unevenFaces()
{
  MeshDraft draft;
  const auto a = draft.add(0, 0, 0), b = draft.add(100, 0, 0), c = draft.add(100, 80, 0), d = draft.add(0, 80, 0);
  draft.quad(a, b, c, d);
  const auto e = draft.add(100, 80.7, 0), f = draft.add(0, 80.7, 0);
  draft.quad(d, c, e, f);
  const auto g = draft.add(50, 120, 0);
  std::uint32_t before = e;
  for (int k = 1; k <= 40; ++k) {
    const auto next = k == 40 ? f : draft.add(100 - 2.5 * k, 80.7, 0);
    draft.face(before, g, next);
    before = next;
  }
  return draft;
}

double
nearest(const Samples& samples, const Eigen::Vector3d& p)
{
  double least = 1e300;
  for (const pcl::PointNormal& s : samples)
    least = std::min(least, (s.getVector3fMap().cast<double>() - p).norm());
  return least;
}

/** Largest distance from places on the whole curved surface, with rims and corners, to the nearest sample. */
double
largestHole(const SurfaceMesh& mesh, const Samples& samples, int tests)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  double largest = 0.0;
  for (std::size_t t = 0; t < mesh.faceCount(); ++t) {
    const MeshPatch patch = mesh.patch(t);
    for (int k = 0; k < 3; ++k)
      largest = std::max(largest, nearest(samples, patch.corners.col(k)));
  }
  for (int i = 0; i < tests; ++i) {
    double at = share(random) * mesh.area();
    std::size_t t = 0;
    while (t + 1 < mesh.faceCount() && at > mesh.faceArea(t))
      at -= mesh.faceArea(t++);
    const double r = std::sqrt(share(random)), s = share(random);
    largest = std::max(largest, nearest(samples, mesh.patch(t).position({1.0 - r, r * (1.0 - s), r * s})));
  }
  return largest;
}

double
leastApart(const Samples& samples)
{
  double least = 1e300;
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      least = std::min<double>(least, (samples[i].getVector3fMap() - samples[j].getVector3fMap()).norm());
  return least;
}

using Bytes = std::array<float, 6>;
std::vector<Bytes>
sorted(const Samples& samples)
{
  std::vector<Bytes> all;
  for (const pcl::PointNormal& s : samples)
    all.push_back({s.x, s.y, s.z, s.normal_x, s.normal_y, s.normal_z});
  std::sort(all.begin(), all.end());
  return all;
}

} // namespace

TEST(MeshSampling, FacesOfEverySizeAreCoveredEvenly)
{
  const auto mesh = unevenFaces().made();
  for (const double spacing : {2.0, 3.3, 7.0}) {
    MeshSampling sampling;
    sampling.setInputMesh(mesh);
    const Samples samples = sampled(sampling, spacing);
    const double hole = largestHole(*sampling.getSurfaceMesh(), samples, 4000);
    EXPECT_LE(hole, spacing);
    const double area = sampling.getSurfaceMesh()->area();
    EXPECT_GT(samples.size(), 1.1 * area / (spacing * spacing));
    EXPECT_LT(samples.size(), 2.0 * area / (spacing * spacing));
    EXPECT_GE(leastApart(samples), 0.3 * spacing); // rims at the same place each have their own points
  }
}

TEST(MeshSampling, TheCurvedSurfaceIsCoveredAndMet)
{
  MeshSampling sampling;
  sampling.setInputMesh(heightMesh(hills, 60.0, 15).made()); // faces of 4 mm
  const Samples samples = sampled(sampling, 1.5);
  const SurfaceMesh& mesh = *sampling.getSurfaceMesh();
  EXPECT_LE(largestHole(mesh, samples, 4000), 1.5);
  double off = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    // On the patch of its face: the least distance over the patch, by steps of falling size.
    const MeshPatch patch = mesh.patch(sampling.getFaceIndices()[i]);
    const Eigen::Vector3d p = samples[i].getVector3fMap().cast<double>();
    Eigen::Vector2d best(1.0 / 3, 1.0 / 3);
    const auto distance = [&](const Eigen::Vector2d& b) { return (patch.position({1 - b[0] - b[1], b[0], b[1]}) - p).norm(); };
    for (double step = 0.3; step > 1e-9; step *= 0.7)
      for (const Eigen::Vector2d& d : {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1), Eigen::Vector2d(1, -1), Eigen::Vector2d(1, 1)})
        for (const double sign : {1.0, -1.0})
          if (distance(best + sign * step * d) < distance(best))
            best += sign * step * d;
    off = std::max(off, distance(best));
    const Eigen::Vector3d normal = patch.normal({1 - best[0] - best[1], best[0], best[1]});
    EXPECT_LT((samples[i].getNormalVector3fMap().cast<double>() - normal).norm(), 2e-5) << i;
  }
  EXPECT_LT(off, 1e-5);
}

TEST(MeshSampling, TheRimHasItsCornersAndNoPlaceFarOff)
{
  MeshSampling sampling;
  sampling.setInputMesh(heightMesh(hills, 60.0, 15).made());
  const Samples samples = sampled(sampling, 2.0);
  const std::vector<MeshRim> rims = meshRims(*sampling.getSurfaceMesh());
  ASSERT_EQ(rims.size(), 1u);
  for (const Eigen::Vector3d& p : rimCurve(*sampling.getSurfaceMesh(), rims[0], 0.3))
    EXPECT_LT(nearest(samples, p), 0.5 * 0.8 * 2.0 + 1e-4);
  for (const double x : {-30.0, 30.0})
    for (const double y : {-30.0, 30.0})
      EXPECT_LT(nearest(samples, {x, y, hills(x, y)}), 1e-5);
}

TEST(MeshSampling, ThreadsChangeNothing)
{
  MeshSampling sampling;
  sampling.setInputMesh(heightMesh(hills, 60.0, 15).made());
  sampling.setCreaseBand(1.0);
  sampling.setNumberOfThreads(1);
  const Samples one = sampled(sampling, 0.7);
  sampling.setNumberOfThreads(2);
  const Samples two = sampled(sampling, 0.7);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_EQ(0, std::memcmp(one[i].data, two[i].data, 12)) << i;
}

TEST(MeshSampling, TheOrderOfFacesAndCornersChangesNothing)
{
  MeshDraft draft = heightMesh(hills, 60.0, 15);
  MeshSampling sampling;
  MeshSettings settings;
  settings.normals = MeshNormals::Max;
  settings.edges = MeshEdges::Straight; // bows follow from sums over the faces of a vertex, in their order
  sampling.setMeshSettings(settings);
  sampling.setInputMesh(draft.made());
  const auto before = sorted(sampled(sampling, 1.1));
  std::mt19937 random(3);
  std::shuffle(draft.faces.begin(), draft.faces.end(), random);
  for (pcl::Vertices& face : draft.faces)
    std::rotate(face.vertices.begin(), face.vertices.begin() + random() % 3, face.vertices.end());
  sampling.setInputMesh(draft.made());
  const auto after = sorted(sampled(sampling, 1.1));
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    for (int k = 0; k < 6; ++k)
      EXPECT_NEAR(before[i][k], after[i][k], k < 3 ? 0.0 : 1e-6) << i; // normals are sums in another order
}

TEST(MeshSampling, AnotherPositionIsCoveredAsWell)
{
  MeshDraft draft = heightMesh(hills, 60.0, 15);
  MeshSampling sampling;
  sampling.setInputMesh(draft.made());
  const std::size_t before = sampled(sampling, 1.5).size();
  const Eigen::Isometry3f motion = Eigen::Translation3f(310, -75, 40) * Eigen::AngleAxisf(1.1f, Eigen::Vector3f(1, 2, 3).normalized());
  for (pcl::PointXYZ& p : draft.points)
    p.getVector3fMap() = motion * p.getVector3fMap().eval();
  sampling.setInputMesh(draft.made());
  const Samples after = sampled(sampling, 1.5);
  EXPECT_LE(largestHole(*sampling.getSurfaceMesh(), after, 3000), 1.5);
  EXPECT_NEAR(static_cast<double>(after.size()), static_cast<double>(before), 0.07 * before); // 1.40 to 1.50 per square of the spacing
}

TEST(MeshSampling, SamplesNearACreaseAreMarked)
{
  MeshSampling sampling;
  sampling.setInputMesh(roofMesh(40.0, 1.0).made());
  sampling.setCreaseBand(3.0);
  const Samples samples = sampled(sampling, 1.0);
  for (std::size_t i = 0; i < samples.size(); ++i)
    EXPECT_EQ(sampling.getInCreaseBand()[i] != 0, std::sqrt(2.0) * std::abs(samples[i].x) < 3.0f) << i;
  EXPECT_NEAR(CreaseLines(*sampling.getSurfaceMesh()).length(), 40.0, 1e-6);
}

TEST(MeshSampling, ChosenFacesHaveTheirOwnRim)
{
  MeshSampling sampling;
  sampling.setInputMesh(boxMesh({30, 20, 10}).made());
  sampled(sampling, 1.0); // prepares the mesh
  const auto mesh = sampling.getSurfaceMesh();
  sampling.setInputMesh(mesh);
  std::vector<std::uint8_t> top;
  for (std::size_t t = 0; t < mesh->faceCount(); ++t)
    top.push_back(mesh->faceNormal(t).z() > 0.9);
  sampling.setFaces(top);
  sampling.setCreaseBand(2.0);
  const Samples samples = sampled(sampling, 1.0);
  std::set<std::uint8_t> marked(sampling.getInCreaseBand().begin(), sampling.getInCreaseBand().end());
  EXPECT_EQ(marked, std::set<std::uint8_t>{0}); // its edges are a rim, not creases
  for (const pcl::PointNormal& s : samples)
    EXPECT_FLOAT_EQ(s.z, 10.0f);
  const auto rims = meshRims(*mesh, top);
  ASSERT_EQ(rims.size(), 1u);
  EXPECT_NEAR(rims[0].length, 100.0, 1e-9);
}

TEST(MeshSampling, WhatCannotBeIsRefusedWithNumbers)
{
  Samples samples;
  MeshSampling sampling;
  sampling.compute(samples);
  EXPECT_EQ(sampling.getStatus().code(), StatusCode::InvalidInput);
  sampling.setInputMesh(boxMesh({3000, 2000, 1000}).made());
  sampling.setSpacing(0.003);
  sampling.compute(samples);
  EXPECT_EQ(sampling.getStatus().code(), StatusCode::InvalidArgument);
  EXPECT_NE(sampling.getStatus().message().find("GB"), std::string::npos) << sampling.getStatus().message();
  EXPECT_NE(sampling.getStatus().message().find("setSpacing"), std::string::npos);
  sampling.setSpacing(-1.0);
  sampling.compute(samples);
  EXPECT_EQ(sampling.getStatus().code(), StatusCode::InvalidArgument);
  sampling.setSpacing(10.0);
  sampling.setFaces({1, 1});
  sampling.compute(samples);
  EXPECT_EQ(sampling.getStatus().code(), StatusCode::InvalidInput);
  EXPECT_TRUE(samples.empty());
}

TEST(MeshSampling, TheDefaultSpacingFollowsAreaAndCurvature)
{
  MeshSampling sampling;
  sampling.setInputMesh(boxMesh({100, 100, 100}).made());
  const Samples flat = sampled(sampling, 0.0);
  EXPECT_GT(flat.size(), 60000u);
  EXPECT_LT(flat.size(), 150000u);
  sampling.setInputMesh(heightMesh([](double x, double y) { return std::sqrt(4.0 - x * x - y * y); }, 2.0, 30).made());
  sampled(sampling, 0.0);
  EXPECT_NEAR(sampling.getUsedSpacing(), 0.1 * std::pow(2.0, 0.75), 0.17);
}

} // namespace mesh_sampling_test
