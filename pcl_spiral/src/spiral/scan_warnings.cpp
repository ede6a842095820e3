// SPDX-License-Identifier: BSD-3-Clause
#include "scan_warnings.h"

#include <pcl_spiral/common/impl/message.h>
#include <pcl_spiral/core/step_over.h>

namespace pcl_spiral {

std::vector<std::string>
scanWarnings(const SurfaceGraph& graph, const SpiralSettings& settings)
{
  constexpr double smallest = 1.0, largest = 1e5; // mm across
  std::vector<std::string> warnings;
  const double across = graph.blocks().box().diagonal(), spacing = graph.spacing();
  if (across < smallest || across > largest)
    warnings.push_back(textOf("the scan is ", across, " mm across: is it in another unit? Scale it to mm"));
  if (const auto step = stepOver(settings.tool_radius, 0.0, settings.scallop_height); step && *step > 0.5 * across)
    warnings.push_back(textOf("turns would lie ", *step, " mm apart on a scan only ", across,
                              " mm across, so that it is one turn or two: check the scan's unit, the tool radius (", settings.tool_radius,
                              " mm) and the scallop height (", settings.scallop_height, " mm)"));
  if (spacing > 2.0 * settings.tool_radius)
    warnings.push_back(textOf("the scan's points lie ", spacing, " mm apart, farther than the cutter is wide (", 2.0 * settings.tool_radius,
                              " mm): hollows between them that it would gouge are not seen; check the scan's unit, scan more "
                              "densely or take a larger tool"));
  return warnings;
}

} // namespace pcl_spiral
