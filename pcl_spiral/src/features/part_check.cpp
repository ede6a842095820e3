#include "part_check.h"

#include <pcl_spiral/common/message.h>
#include <pcl_spiral/features/surface_parts.h>

#include <algorithm>
#include <utility>

namespace pcl_spiral {

Status
checkParts(const SurfaceGraph& graph, const BoundaryOptions& options, std::vector<std::uint32_t>& part_of,
           BoundaryCounts& counts)
{
  constexpr double specks_together = 10.0; // of the largest one
  SurfaceParts found;
  std::vector<std::size_t> sizes;
  found.of_triangle = graph.triangulation().parts(sizes);
  if (sizes.empty())
    return {StatusCode::InvalidInput, "the points make no surface: no three of them are neighbours of each other; "
                                      "check that the cloud is a surface and not a line or scattered points"};
  const auto whole = static_cast<double>(graph.triangulation().triangleCount());
  counts.left_out_parts = sizes.size() - 1;
  counts.left_out_triangles = graph.triangulation().triangleCount() - sizes[0];
  std::vector<SurfacePart> parts = sizes.size() > 1 ? surfaceParts(graph).parts : std::vector<SurfacePart>();
  // What is much larger than the part of most triangles is no speck: a coarse scan has few of them beside a fine one.
  const auto isSpeck = [&](const SurfacePart& part) {
    return static_cast<double>(part.triangles) <= options.largest_left_out * whole &&
           part.area <= 2.0 * parts.front().area;
  };
  const bool second = sizes.size() > 1 && !std::all_of(parts.begin() + 1, parts.end(), isSpeck);
  const bool scattered =
      static_cast<double>(counts.left_out_triangles) > specks_together * options.largest_left_out * whole;
  if (sizes.size() > 1 && (second || scattered)) {
    if (second)
      parts.erase(std::remove_if(parts.begin() + 1, parts.end(), isSpeck), parts.end());
    return {StatusCode::InvalidInput,
            textOf("the cloud has ", parts.size(), " separate parts: ", partsText(parts),
                   second ? "; keep the largest one alone (--largest), or the one to be machined, and remove the others "
                            "from the cloud"
                          : "; too many for specks: the scan does not hang together, so scan more densely, or keep the "
                            "largest part alone (--largest)")};
  }
  if (sizes.size() > 1) {
    const std::vector<std::uint8_t> apart = apartFrom(graph, found, 0);
    counts.left_out_points = static_cast<std::size_t>(std::count(apart.begin(), apart.end(), 1));
  }
  part_of = std::move(found.of_triangle);
  return Status::success();
}

} // namespace pcl_spiral
