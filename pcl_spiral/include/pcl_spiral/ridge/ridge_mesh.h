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
  Polyline vertices; ///< on the ridge: those of a station of the rail one after the other, along the generator
  std::vector<std::array<std::uint32_t, 3>> faces; ///< counter-clockwise seen from above
  std::size_t along = 0, across = 0; ///< cells along the rail and along the generator; each is two faces

  /** The same in single precision, as PCL has meshes. */
  pcl::PolygonMesh polygons() const;
};

/** Cells so small that no face lies farther than \p chord_error from the ridge; none is more than four times as long as wide. Round a
 *  closed rail the last cells join the first. InvalidArgument: a chord error that is not above 0, or so small that it takes more than a
 *  million faces; the message names one that goes. InvalidInput: a ridge so slender that it takes as many at any. */
Status ridgeMesh(const RidgeSurface& surface, double chord_error, RidgeMesh& mesh);

/** The same as a surface to locate cutters on (CutterLocation::setInputMesh) and to draw. Its faces are curved, so the surface is nearer to
 *  the ridge than the chord error, up to single precision. \p mesh is null on failure. */
Status ridgeMesh(const RidgeSurface& surface, double chord_error, SurfaceMesh::ConstPtr& mesh);

} // namespace pcl_spiral
