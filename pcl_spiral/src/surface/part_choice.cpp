// SPDX-License-Identifier: BSD-3-Clause
#include "part_choice.h"

#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>

namespace pcl_spiral {

Status
choosePart(const SurfaceGraph& graph, const SurfaceParts& found, const SurfaceSettings& settings, std::size_t& kept)
{
  constexpr double far = 10.0; // spacings
  if (found.parts.empty())
    return Status::success();
  if (!settings.part_at) {
    const auto smaller = [](const SurfacePart& a, const SurfacePart& b) { return a.area < b.area; };
    kept = static_cast<std::size_t>(std::max_element(found.parts.begin(), found.parts.end(), smaller) - found.parts.begin());
    return Status::success();
  }
  double distance = 0.0;
  kept = nearestPart(graph, found, *settings.part_at, distance);
  if (distance <= far * graph.spacing())
    return Status::success();
  return {StatusCode::InvalidArgument,
          Diagnostic("the place ", Place(*settings.part_at), " is ", distance,
                     " {mm} from the nearest point of the {scan}: give a place on the part ({setPartAt}); the {scan} has ",
                     found.parts.size(), found.parts.size() == 1 ? " part: " : " separate parts: ", partsText(found.parts))};
}

Status
checkChosen(const SurfaceGraph& graph, const SurfaceSettings& settings)
{
  if (settings.part_at || settings.largest_part)
    return Status::success();
  const SurfaceParts parts = surfaceParts(graph);
  if (otherParts(parts.parts, largest_cluster) != OtherParts::TooLarge)
    return Status::success();
  return {StatusCode::InvalidInput, severalPartsText(graph, parts)};
}

Diagnostic
keptPartText(std::size_t all, std::size_t left_out, const SurfaceParts& found, const SurfaceSettings& settings, std::size_t kept)
{
  SurfaceParts others = found;
  const SurfacePart part = found.parts[kept];
  others.parts.erase(others.parts.begin() + static_cast<std::ptrdiff_t>(kept));
  const Eigen::Vector3d size = part.box.sizes();
  Diagnostic text =
      Diagnostic("kept only the ", settings.part_at ? Diagnostic("part nearest to ", Place(*settings.part_at)) : Diagnostic("largest"),
                 " of ", found.parts.size(), " separate parts, ", partsText({part}), ", ", size.x(), " by ", size.y(), " by ", size.z(),
                 " {mm}, with ", 100.0 * static_cast<double>(all - left_out) / static_cast<double>(all),
                 " % of the points; left out the others, with ", left_out, " points: ", partsText(others.parts));
  if (!settings.part_at)
    text += "; if another one is to be machined, give a place on it ({setPartAt})";
  return text;
}

} // namespace pcl_spiral
