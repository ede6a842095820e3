// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Options of the graph of a surface. Private.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>
#include <pcl_spiral/surface/surface.h>

namespace pcl_spiral {

constexpr double far_above = 1e9; // mm: all points of a closed surface face its direction

/** Those that \p settings ask for. */
inline SurfaceGraphOptions
graphOptions(const SurfaceSettings& settings)
{
  SurfaceGraphOptions options;
  options.neighbours = settings.neighbours;
  options.max_circumradius = settings.alpha;
  options.view_point = settings.view_point;
  options.heights = settings.heights;
  if (settings.heights)
    options.view_point = settings.heights->along() * far_above;
  options.flip_normals = settings.flip_normals;
  options.trust_normals = settings.trust_normals;
  return options;
}

} // namespace pcl_spiral
