// SPDX-License-Identifier: BSD-3-Clause
#include "void_rings.h"

#include <pcl_spiral/surface/impl/scan_voids.h>

namespace pcl_spiral {

std::vector<Ring>
ringsWithVoids(const SurfaceGraph& graph, const std::vector<std::uint32_t>& part_of, double width)
{
  const Triangulation& all = graph.triangulation();
  std::vector<std::uint8_t> open(all.triangleCount(), 0);
  bool any = false;
  const ScanVoids voids(graph);
  for (const ScanVoid& found : voids.voids())
    if (found.width >= width)
      for (const std::uint32_t t : found.triangles) {
        open[t] = 1;
        any = true;
      }
  if (!any)
    return boundaryRings(all, part_of, 0);
  std::vector<Triangulation::Triangle> kept;
  std::vector<std::uint32_t> parts;
  for (std::size_t t = 0; t < open.size(); ++t)
    if (!open[t]) {
      kept.push_back(all.triangle(t));
      parts.push_back(part_of[t]);
    }
  return boundaryRings(Triangulation(graph.size(), kept), parts, 0);
}

} // namespace pcl_spiral
