// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Normals of a mesh's vertices. Private to mesh.
 */
#pragma once

#include "corner_sectors.h"

#include <pcl_spiral/mesh/surface_mesh.h>

#include <Eigen/Core>

namespace pcl_spiral {

/** One unit normal per sector, by \p kind. \p fallback has 1 for each sector whose normal is by Max although a fitted one was asked
 *  for. */
std::vector<Eigen::Vector3d> sectorNormals(const Triangulation& mesh, const std::vector<Eigen::Vector3d>& positions,
                                           const CornerSectors& sectors, MeshNormals kind, std::vector<std::uint8_t>& fallback);

/** Noise of the vertices, mm: median, over some 2,000 sectors, of the noise about surfaces fitted to two rings. 0 if most of
 *  these are not determined, as on plain CAD parts. */
double vertexNoise(const Triangulation& mesh, const std::vector<Eigen::Vector3d>& positions, const CornerSectors& sectors);

} // namespace pcl_spiral
