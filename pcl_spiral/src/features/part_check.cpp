// SPDX-License-Identifier: BSD-3-Clause
#include "part_check.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/graph/impl/surface_parts.h>

#include <algorithm>
#include <utility>

namespace pcl_spiral {

Status
checkParts(const SurfaceGraph& graph, const BoundaryOptions& options, std::vector<std::uint32_t>& part_of, BoundaryReport& counts)
{
  SurfaceParts found;
  std::vector<std::size_t> sizes;
  found.of_triangle = graph.triangulation().parts(sizes);
  if (sizes.empty())
    return {StatusCode::InvalidInput, "the points form no surface: no three of them are neighbours of each other; "
                                      "check that the {cloud} is a surface, not a line or random points"};
  const std::size_t all = graph.triangulation().triangleCount();
  counts.left_out_parts = sizes.size() - 1;
  counts.left_out_triangles = all - sizes[0];
  const SurfaceParts several = sizes.size() > 1 ? surfaceParts(graph) : SurfaceParts();
  const std::vector<SurfacePart>& parts = several.parts;
  const OtherParts others = otherParts(parts, options.largest_left_out);
  if (others == OtherParts::TooLarge || others == OtherParts::TooMany)
    return {StatusCode::InvalidInput,
            others == OtherParts::TooLarge
                ? severalPartsText(graph, several)
                : Diagnostic("the {cloud} has ", parts.size(), " separate parts: ", partsText(parts),
                             "; this is too many: the {scan} is disconnected, so {scan more densely}, or keep only the largest part "
                             "({setLargestPart})")};
  if (sizes.size() > 1) {
    const std::vector<std::uint8_t> apart = apartFrom(graph, found, 0);
    counts.left_out_points = static_cast<std::size_t>(std::count(apart.begin(), apart.end(), 1));
  }
  part_of = std::move(found.of_triangle);
  return Status::success();
}

} // namespace pcl_spiral
