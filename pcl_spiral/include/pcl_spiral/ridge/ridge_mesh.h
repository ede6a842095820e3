// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Triangles over a ridge.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/ridge/ridge_surface.h>

#include <pcl/PolygonMesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** A ridge as triangles between equal stations of its rail and of its generator. Lengths in mm. */
struct RidgeMesh {
  Polyline vertices;                               ///< on the ridge: station by station along the rail; at each station along the generator
  std::vector<std::array<std::uint32_t, 3>> faces; ///< counter-clockwise seen from above
  std::size_t along = 0, across = 0;               ///< cells along the rail and along the generator; each cell is two faces

  /** The same in single precision, as a mesh of PCL. */
  pcl::PolygonMesh polygons() const;
};

/** Cells so small that no face is farther than \p chord_error from the ridge; no cell is more than four times as long as wide. On
 *  a closed rail, the last cells join the first. InvalidArgument: a chord error not above 0, or so small that it needs more than a
 *  million faces; the message gives one that works. InvalidInput: a ridge so slender that any chord error needs that many faces. */
Status ridgeMesh(const RidgeSurface& surface, double chord_error, RidgeMesh& mesh);

/** The same as a surface, to locate cutters on (CutterLocation::setInputMesh) and to draw. Its faces are curved, so
 *  the surface is nearer to the ridge than the chord error, up to single precision. \p mesh is null on failure. */
Status ridgeMesh(const RidgeSurface& surface, double chord_error, SurfaceMesh::ConstPtr& mesh);

} // namespace pcl_spiral
