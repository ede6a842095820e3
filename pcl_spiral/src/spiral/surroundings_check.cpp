// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/surroundings_check.h>

#include <pcl_spiral/collision/impl/way_check.h>
#include <pcl_spiral/common/impl/toolpath_fields.h>

#include <algorithm>

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

void
gapsToHoles(const Surroundings& around, std::vector<BoundaryLoop>& loops)
{
  for (BoundaryLoop& loop : loops) {
    const Eigen::Vector3d across = loop.type == LoopType::ScanGap ? polygonArea(loop.curve) : Eigen::Vector3d::Zero();
    if (across.isZero(0.0))
      continue;
    const Prism inside(loop.curve, across);
    if (!inside.fault().empty())
      continue;
    for (const auto points : {&around.kept_out, &around.beside, &around.standing})
      if (std::any_of(points->begin(), points->end(), [&](const Eigen::Vector3f& p) { return inside.contains(p.cast<double>()); }))
        loop.type = LoopType::Inner;
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
