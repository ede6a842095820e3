// SPDX-License-Identifier: BSD-3-Clause
#include "scan_warnings.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/step_over.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pcl_spiral {

namespace {

constexpr double rounded_share = 0.25; // of the chord error: a tolerance should be four times what it is measured by (ANSI/NCSL Z540-1)

/** Largest distance, mm, by which single precision moves a point in \p box. */
double
largestRounding(const Box& box)
{
  double squared = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float largest = std::max(std::abs(box.low[axis]), std::abs(box.high[axis]));
    const double half_step = 0.5 * (std::nextafter(largest, std::numeric_limits<float>::infinity()) - largest);
    squared += half_step * half_step;
  }
  return std::sqrt(squared);
}

} // namespace

Diagnostics
scanWarnings(const SurfaceGraph& graph, const SpiralSettings& settings)
{
  constexpr double smallest = 1.0, largest = 1e5; // mm across
  Diagnostics warnings;
  const double across = graph.blocks().box().diagonal(), spacing = graph.spacing();
  if (across < smallest || across > largest)
    warnings.push_back(Diagnostic("the {scan} is ", across, " {mm} across: is it in another unit? {Scale it to mm}"));
  if (const auto step = stepOver(settings.tool_radius, 0.0, settings.scallop_height); step && *step > 0.5 * across)
    warnings.push_back(
        Diagnostic("turns would lie ", *step, " {mm} apart, but the {scan} is only ", across,
                   " {mm} across: the path would have only one or two turns; check the unit of the {scan}, the tool radius (",
                   settings.tool_radius, " {mm}) and the scallop height (", settings.scallop_height, " {mm})"));
  if (const double rounding = largestRounding(graph.blocks().box()); rounding > rounded_share * settings.chord_error)
    warnings.push_back(
        Diagnostic("coordinates of the {scan} are so large that single precision rounds its points, and those of the path, by up "
                   "to ",
                   rounding, " {mm}, and the chord error is ", settings.chord_error,
                   " {mm}: move the {scan} nearer to (0, 0, 0), or allow a larger chord error ({setChordError})"));
  if (!showsHollows(spacing, settings.tool_radius))
    warnings.push_back(
        Diagnostic("the points of the {scan} lie ", spacing, " {mm} apart, more than the cutter's width (", 2.0 * settings.tool_radius,
                   " {mm}): the {scan} does not show hollows between them, and the cutter may gouge there; check the unit of the "
                   "{scan}, {scan more densely} or use a larger tool"));
  return warnings;
}

} // namespace pcl_spiral
