// SPDX-License-Identifier: BSD-3-Clause
#include "corner_sectors.h"

#include <numeric>

namespace pcl_spiral {

CornerSectors
cornerSectors(const Triangulation& mesh, const std::vector<std::uint8_t>& creases)
{
  constexpr std::uint32_t none = Triangulation::none;
  const std::size_t n = mesh.halfEdgeCount();
  CornerSectors sectors;
  sectors.of_corner.assign(n, none);
  std::uint32_t count = 0;
  for (std::uint32_t first = 0; first < n; ++first) {
    if (sectors.of_corner[first] != none)
      continue;
    // Counter-clockwise from the corner until a crease, the boundary or the start; then clockwise.
    for (std::uint32_t h = first; h != none && sectors.of_corner[h] == none;) {
      sectors.of_corner[h] = count;
      const std::uint32_t side = Triangulation::previous(h);
      h = creases[side] ? none : mesh.opposite(side);
    }
    for (std::uint32_t h = first;;) {
      const std::uint32_t other = creases[h] ? none : mesh.opposite(h);
      h = other == none ? none : Triangulation::next(other);
      if (h == none || sectors.of_corner[h] != none)
        break;
      sectors.of_corner[h] = count;
    }
    ++count;
  }
  sectors.begin.assign(count + 1, 0);
  for (const std::uint32_t s : sectors.of_corner)
    ++sectors.begin[s + 1];
  std::partial_sum(sectors.begin.begin(), sectors.begin.end(), sectors.begin.begin());
  sectors.corners.resize(n);
  std::vector<std::uint32_t> next(sectors.begin.begin(), sectors.begin.end() - 1);
  for (std::uint32_t h = 0; h < n; ++h)
    sectors.corners[next[sectors.of_corner[h]]++] = h;
  return sectors;
}

} // namespace pcl_spiral
