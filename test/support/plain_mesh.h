// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Triangle meshes for tests.
 */
#pragma once

#include <pcl_spiral/mesh/surface_mesh.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include <array>
#include <vector>

namespace pcl_spiral::test {

using Corners = std::vector<Eigen::Vector3d>;
using Faces = std::vector<std::array<std::uint32_t, 3>>;

/** Vertices and faces. */
struct PlainMesh {
  Corners corners;
  Faces faces;

  /** Two triangles for the quadrilateral a, b, c, d. */
  void addQuad(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d)
  {
    const auto first = static_cast<std::uint32_t>(corners.size());
    corners.insert(corners.end(), {a, b, c, d});
    faces.push_back({first, first + 1, first + 2});
    faces.push_back({first, first + 2, first + 3});
  }

  pcl::PolygonMesh::Ptr polygons() const
  {
    pcl::PointCloud<pcl::PointXYZ> cloud;
    for (const Eigen::Vector3d& p : corners)
      cloud.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
    pcl::PolygonMesh::Ptr mesh(new pcl::PolygonMesh);
    pcl::toPCLPointCloud2(cloud, mesh->cloud);
    for (const auto& f : faces) {
      pcl::Vertices polygon;
      polygon.vertices.assign(f.begin(), f.end());
      mesh->polygons.push_back(polygon);
    }
    return mesh;
  }

  SurfaceMesh::ConstPtr surface() const
  {
    SurfaceMesh::ConstPtr mesh;
    const Status status = SurfaceMesh::make(*polygons(), {}, mesh);
    EXPECT_TRUE(status.ok()) << status.message();
    return mesh;
  }
};

/** The graph of \p height(x, y) over the square of half the side \p half, in steps of \p step; diagonals to and fro. */
template <typename Height>
PlainMesh
graphMesh(const Height& height, double half, double step)
{
  PlainMesh mesh;
  const int n = static_cast<int>(std::lround(2.0 * half / step));
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = -half + 2.0 * half * i / n, y = -half + 2.0 * half * j / n;
      mesh.corners.emplace_back(x, y, height(x, y));
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const auto a = static_cast<std::uint32_t>(j * (n + 1) + i), b = a + 1, c = a + n + 2, d = a + n + 1;
      if ((i + j) % 2 == 0)
        mesh.faces.insert(mesh.faces.end(), {{a, b, c}, {a, c, d}});
      else
        mesh.faces.insert(mesh.faces.end(), {{a, b, d}, {b, c, d}});
    }
  return mesh;
}

} // namespace pcl_spiral::test
