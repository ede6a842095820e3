// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/spiral/impl/path_size.h>

#include "common/available_memory.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/step_over.h>
#include <pcl_spiral/spiral/impl/turn_function.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_spiral {

PathSize
roughPathSize(double area, const SpiralSettings& settings)
{
  PathSize size;
  size.step_over = stepOver(settings.tool_radius, 0.0, settings.scallop_height).value_or(0.0);
  size.step = settings.max_step > 0.0 ? settings.max_step : settings.tool_radius;
  size.turns = 0.5 * std::sqrt(area) / size.step_over;
  size.points = area / (size.step_over * size.step);
  return size;
}

PathSize
TurnFunction::pathSize() const
{
  PathSize size;
  size.turns = static_cast<double>(turns_);
  size.knots = size.turns * static_cast<double>(lines_.size());
  double travelled = 0.0, across = 0.0; // length of the turns between two stations; length of the longest line
  for (const RadialLine& line : lines_)
    across = std::max(across, line.length());
  for (std::size_t k = 0; k + 1 < stations_.front().size(); ++k) {
    std::vector<double> gap(lines_.size());
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const auto &here = lines_[i].feet, &next = lines_[(i + 1) % lines_.size()].feet;
      gap[i] = 0.5 * ((here[k].position - next[k].position).norm() + (here[k + 1].position - next[k + 1].position).norm());
    }
    const double around = std::accumulate(gap.begin(), gap.end(), 0.0);
    const double bend = 2.0 * std::sqrt(2.0 * settings_.chord_error * around / (2.0 * pi)); // of a circle as long
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const double turns = size.turns * (stations_[i][k + 1].share - stations_[i][k].share);
      travelled += turns * gap[i];
      size.points += turns * gap[i] / std::min({stations_[i][k].feed_step, bend, max_step_});
    }
  }
  size.step_over = across / size.turns;
  size.step = travelled / size.points;
  return size;
}

Status
checkPathSize(const PathSize& size, double area, const SpiralSettings& settings, double most)
{
  const auto memory = availableMemory();
  const bool too_many = !(size.points <= most) || !(size.knots <= most);
  if (!too_many && !(memory && size.bytes() > *memory))
    return Status::success();
  const Diagnostic asked =
      Diagnostic("this path would be too large: about ", size.points, " points (", area, " {mm2}, ", size.turns, " turns ", size.step_over,
                 " {mm} apart, moves of ", size.step, " {mm}) and ", size.bytes() / 1e9, " GB of memory");
  const Diagnostic limit = too_many ? Diagnostic(", but at most ", most_path_points, " points are possible")
                                    : Diagnostic(", but only ", *memory / 1e9, " GB are free");
  return {StatusCode::InvalidArgument,
          Diagnostic(asked, limit,
                     "; is the {scan} in another unit than {mm} ({ReadOptions::unit})? Otherwise raise the scallop height, now ",
                     settings.scallop_height, " {mm} ({setScallopHeight}), ",
                     settings.max_step > 0.0 ? Diagnostic("the longest move, now ", settings.max_step, " {mm} ({setMaxStep}), ") : "",
                     "or take a larger tool, now of radius ", settings.tool_radius, " {mm} ({setToolRadius})")};
}

} // namespace pcl_spiral
