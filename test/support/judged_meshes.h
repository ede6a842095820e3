// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Meshes to sample and to check paths against: a landform over a grid, its exact surface, boxes, roofs.
 */
#pragma once

#include <pcl/PolygonMesh.h>
#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <vector>

namespace pcl_spiral::test {

/** Points and faces of a mesh under construction. */
struct MeshDraft {
  pcl::PointCloud<pcl::PointXYZ> points;
  std::vector<pcl::Vertices> faces;

  std::uint32_t add(double x, double y, double z)
  {
    points.emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
    return static_cast<std::uint32_t>(points.size() - 1);
  }
  void face(std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    pcl::Vertices corners;
    for (const std::uint32_t v : {a, b, c})
      corners.vertices.push_back(static_cast<pcl::index_t>(v));
    faces.push_back(corners);
  }
  void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
  {
    face(a, b, c);
    face(a, c, d);
  }
  pcl::PolygonMesh::Ptr made() const
  {
    auto mesh = pcl::make_shared<pcl::PolygonMesh>();
    pcl::toPCLPointCloud2(points, mesh->cloud);
    mesh->polygons = faces;
    return mesh;
  }
};

/** z = height(x, y) over a square of \p cells x \p cells about the origin, \p size mm wide, seen from +z. */
template <typename Height>
MeshDraft
heightMesh(Height height, double size, int cells)
{
  MeshDraft draft;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const double x = size * (static_cast<double>(i) / cells - 0.5), y = size * (static_cast<double>(j) / cells - 0.5);
      draft.add(x, y, height(x, y));
    }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i)
      draft.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  return draft;
}

/** Hills 60, 38 and 25 mm apart. */
inline double
hills(double x, double y)
{
  const auto wave = [](double width) { return 2.0 * M_PI / width; };
  return 1.6 * std::sin(wave(60) * (x + 0.3 * y) + 0.3) + 0.9 * std::sin(wave(38) * (0.5 * x + y) + 1.1) +
         0.35 * std::sin(wave(25) * (0.6 * y - x) + 2.0);
}

/** Normal of a height function, by differences. */
template <typename Height>
Eigen::Vector3d
heightNormal(Height height, double x, double y)
{
  constexpr double d = 1e-4;
  return Eigen::Vector3d((height(x - d, y) - height(x + d, y)) / (2 * d), (height(x, y - d) - height(x, y + d)) / (2 * d), 1.0)
      .normalized();
}

/** A closed box from 0 to \p size; its facets are as large as its sides. */
inline MeshDraft
boxMesh(const Eigen::Vector3d& size)
{
  MeshDraft draft;
  for (int k = 0; k < 8; ++k)
    draft.add(k & 1 ? size.x() : 0.0, k & 2 ? size.y() : 0.0, k & 4 ? size.z() : 0.0);
  draft.quad(4, 5, 7, 6); // top
  draft.quad(0, 2, 3, 1);
  draft.quad(0, 1, 5, 4);
  draft.quad(1, 3, 7, 5);
  draft.quad(3, 2, 6, 7);
  draft.quad(2, 0, 4, 6);
  return draft;
}

/** Two planes that meet along x = 0, each falling outwards by \p slope, \p size mm wide and long: a roof, or with a negative
 *  slope a valley. */
inline MeshDraft
roofMesh(double size, double slope)
{
  MeshDraft draft;
  const double half = 0.5 * size;
  for (const double y : {-half, half})
    for (const double x : {-half, 0.0, half})
      draft.add(x, y, -slope * std::abs(x));
  draft.quad(0, 1, 4, 3);
  draft.quad(1, 2, 5, 4);
  return draft;
}

} // namespace pcl_spiral::test
