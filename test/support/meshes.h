// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Triangle meshes with their vertices on test surfaces, the same on every platform for a given seed.
 */
#pragma once

#include "support/surfaces.h"

#include <pcl/PolygonMesh.h>

#include <array>
#include <cstdint>

namespace pcl_spiral::test {

/** Vertices in double precision, and faces counter-clockwise seen from outside the material. */
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;

  /** As PCL mesh, in floats. */
  pcl::PolygonMesh::Ptr polygons() const;
};

/** A grid of cells x cells, each cut in two, over the rectangle from the origin to \p extent. Inner vertices are moved by up to
 *  \p jitter cells in each direction, vertices on the rim along it; with \p jitter above 0 the diagonals are random. */
TriangleMesh gridMesh(const AnalyticSurface& surface, const Eigen::Vector2d& extent, std::size_t cells, double jitter = 0.0,
                      std::uint64_t seed = 1);

/** Delaunay triangles over \p count random points of that rectangle; \p on_rim of them are spread evenly on its rim, with the
 *  corners. */
TriangleMesh delaunayMesh(const AnalyticSurface& surface, const Eigen::Vector2d& extent, std::size_t count, std::size_t on_rim,
                          std::uint64_t seed = 1);

/** The mesh with its vertices raised by Gaussian noise of \p sigma. */
TriangleMesh withNoise(TriangleMesh mesh, double sigma, std::uint64_t seed = 1);

/** Steep waves with randomly moved vertices, 24 x 24 cells of 1 mm: walls, creases, and strongly curved faces. */
TriangleMesh ruggedMesh(std::uint64_t seed);

/** A binary STL file. */
void writeStl(const std::string& file, const TriangleMesh& mesh);

} // namespace pcl_spiral::test
