// SPDX-License-Identifier: BSD-3-Clause
// Sections of a mesh with strongly curved faces: contacts stay on it.
#include <pcl_spiral/mesh/impl/patch_tree.h>
#include <pcl_spiral/mesh/mesh_sections.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rugged_sections_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

/** Distance of \p p from the flat faces, by a check of all faces. */
double
distanceFromFaces(const TriangleMesh& mesh, const Vector3d& p)
{
  double least = 1e300;
  for (const auto& f : mesh.faces) {
    Eigen::Matrix3d corners;
    corners << mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]];
    least = std::min(least, (corners * nearestOnTriangle(corners, p) - p).norm());
  }
  return least;
}

} // namespace

TEST(RuggedSections, ContactsStayOnTheFaces)
{
  for (const std::uint64_t seed : {1, 2, 3}) {
    const TriangleMesh mesh = ruggedMesh(seed);
    double longest = 0.0;
    for (const auto& f : mesh.faces)
      for (int k = 0; k < 3; ++k)
        longest = std::max(longest, (mesh.vertices[f[k]] - mesh.vertices[f[(k + 1) % 3]]).norm());
    MeshSections sections;
    sections.setInputMesh(mesh.polygons());
    sections.setPlaneNormal(Vector3d::UnitY());
    sections.setStepOver(0.5);
    sections.setChordError(0.005);
    DrivePasses passes;
    sections.compute(passes);
    ASSERT_TRUE(sections.getStatus().ok()) << sections.getStatus().message();
    double farthest = 0.0;
    for (const DrivePass& pass : passes)
      for (const DrivePoint& point : pass.points)
        farthest = std::max(farthest, distanceFromFaces(mesh, point.position));
    EXPECT_LT(farthest, 0.25 * longest); // no edge is corrected by more
  }
}

} // namespace rugged_sections_test
