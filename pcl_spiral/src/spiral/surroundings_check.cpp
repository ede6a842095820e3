// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/surroundings_check.h>

#include "cleaning/standing_clusters.h"
#include "collision/ball_way.h"
#include "search/pieces.h"
#include <pcl_spiral/collision/impl/false_echoes.h>
#include <pcl_spiral/collision/impl/way_check.h>
#include <pcl_spiral/common/impl/toolpath_fields.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/tolerances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl_spiral {

Surroundings
withSurface(Surroundings around, const Surface& surface)
{
  const LeftOutPoints& left_out = surface.leftOut();
  for (std::size_t i = 0; i < left_out.why.size(); ++i)
    if (left_out.why[i] == LeftOut::OtherPart)
      around.standing.push_back(left_out.positions[i]);
  const std::vector<Eigen::Vector3f> ridden = surface.riddenPoints();
  around.standing.insert(around.standing.end(), ridden.begin(), ridden.end());
  return around;
}

std::vector<Eigen::Vector3f>
offSurface(const Surface& surface, const std::vector<Eigen::Vector3f>& points)
{
  const PointBlocks& blocks = surface.graph().blocks();
  return pointsWhere(points, [&](const Eigen::Vector3f& point) {
    const Eigen::Vector3d p = point.cast<double>();
    const std::uint32_t nearest = blocks.nearest(p);
    const Eigen::Vector3d from = p - surface.position(nearest);
    return from.norm() > unseen * surface.spacing() || std::abs(surface.normal(nearest).dot(from)) > far_over_noise * surface.noise();
  });
}

void
gapsToHoles(const Surroundings& around, const Surface& surface, double radius, std::vector<BoundaryLoop>& loops, Diagnostics& warnings)
{
  if (around.empty())
    return;
  for (BoundaryLoop& loop : loops) {
    const Eigen::Vector3d across = loop.type == LoopType::ScanGap ? polygonArea(loop.curve) : Eigen::Vector3d::Zero();
    if (across.isZero(0.0))
      continue;
    const Prism inside(loop.curve, across);
    if (!inside.fault().empty())
      continue;
    const Eigen::Vector3d normal = surface.normal(surface.graph().blocks().nearest(loop.curve.front()));
    const Eigen::Vector3d up = across.dot(normal) < 0.0 ? Eigen::Vector3d(-across.normalized()) : Eigen::Vector3d(across.normalized());
    const auto shows = [&](const Eigen::Vector3f& point) {
      const Eigen::Vector3d p = point.cast<double>();
      const double height = up.dot(p - loop.curve.front());
      return height > -radius && height < reach_radii * radius && inside.contains(p);
    };
    std::ptrdiff_t count = 0;
    for (const auto points : {&around.kept_out, &around.beside, &around.standing})
      count += std::count_if(points->begin(), points->end(), shows);
    if (count <= static_cast<std::ptrdiff_t>(largest_echo))
      continue;
    loop.type = LoopType::Inner;
    warnings.push_back(Diagnostic("a gap at ", Place(loop.curve.front()), ", ", inside.width(), " {mm} wide, is a hole that is not cut: ",
                                  count, " points of the {scan} that are not of the part lie in it"));
  }
}

Status
checkSurroundings(const SpiralPath& path, const SpiralSettings& settings, const Surroundings& around, SpiralReport& report)
{
  if (around.empty())
    return Status::success();
  pcl::PointCloud<ToolpathPoint> points;
  points.resize(path.contacts.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    ToolpathFields<ToolpathPoint>::set(points[i], path.contacts[i], path.normals[i], path.axes[i], path.arc_lengths[i], path.turns[i],
                                       path.over_gap[i] != 0);
  WayTool tool;
  tool.radius = settings.tool_radius;
  tool.allowed = gougeTolerance(settings.chord_error, report.noise);
  tool.spacing = report.spacing;
  tool.tilted = !settings.fixed_axis && settings.tilt_angle != 0.0;
  tool.led = !settings.fixed_axis && settings.lead_angle != 0.0;
  return checkWay(points, tool, around, report.blocked_way, report.warnings);
}

} // namespace pcl_spiral
