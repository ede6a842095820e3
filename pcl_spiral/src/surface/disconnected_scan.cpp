// SPDX-License-Identifier: BSD-3-Clause
#include "disconnected_scan.h"

#include "cleaning/standing_clusters.h"
#include <pcl_spiral/core/diagnostic.h>

#include <cmath>

namespace pcl_spiral {
namespace {

Eigen::Vector3d
middleOf(const Box& box)
{
  return 0.5 * (Eigen::Map<const Eigen::Vector3f>(box.low.data()).cast<double>() +
                Eigen::Map<const Eigen::Vector3f>(box.high.data()).cast<double>());
}

} // namespace

bool
isOverPart(const SurfaceGraph& graph, const Eigen::Vector3d& point)
{
  constexpr double few = 3.0, rough = 0.1; // spacings; of the height, since the nearest point is a foot but for noise
  const std::uint32_t nearest = graph.blocks().nearest(point);
  const Eigen::Vector3d off = point - graph.position(nearest);
  const double height = std::abs(off.dot(graph.normal(nearest)));
  return (off - off.dot(graph.normal(nearest)) * graph.normal(nearest)).norm() <= few * graph.spacing() + rough * height;
}

Status
disconnectedRefusal(const SurfaceGraph& graph, const std::vector<Eigen::Vector3f>& isolated, std::size_t given)
{
  const StandingPoints lie = standingPoints(graph, isolated);
  const Box box = graph.blocks().box();
  return {StatusCode::InvalidInput,
          Diagnostic(isolated.size(), " of ", given, " points are isolated, far from the densest part of the {cloud}, which lies around ",
                     Place(middleOf(box)), ", is ", box.diagonal(), " {mm} across and has a point every ", graph.spacing(),
                     " {mm}; half of them are more than ", lie.median_height, " {mm} above or below its surface, the farthest ",
                     lie.largest_height,
                     " {mm}: the {scan} is disconnected; where trees or flying points are, crop the {scan} to the part "
                     "({setCrop}); otherwise leave that part out, or thin the {cloud} to an even spacing ({setThinning})")};
}

} // namespace pcl_spiral
