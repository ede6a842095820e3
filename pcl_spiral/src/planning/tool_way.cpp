// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tool_way.h"

#include <pcl_spiral/collision/impl/false_echoes.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/verify/holder_check.h>

#include <algorithm>
#include <array>
#include <set>

namespace pcl_spiral {
namespace {

/** The zone of \p program in which the axis of the deepest place is blended; null if it is not. */
const PoleZone*
zoneOf(const MachineProgram& program, const LeadCollision& deepest)
{
  const double at = program.blocks[deepest.block].arc_length;
  const std::vector<PoleZone>& zones = program.report.poles;
  const auto zone = std::find_if(zones.begin(), zones.end(), [at](const PoleZone& z) { return at > z.begin && at <= z.end; });
  return zone == zones.end() ? nullptr : &*zone;
}

const char*
wayOf(BlockSection section)
{
  switch (section) {
  case BlockSection::Start:
  case BlockSection::Position:
    return "on its way over the part";
  case BlockSection::Approach:
    return "on its way down to the path";
  case BlockSection::LeadIn:
    return "in its lead to the path";
  case BlockSection::Link:
    return "on its link to the next pass";
  case BlockSection::LeadOut:
    return "in its lead off the path";
  case BlockSection::Retract:
  case BlockSection::End:
    return "on its way up from the path";
  case BlockSection::Cut:
    return "on the path";
  default:
    return "while it unwinds";
  }
}

/** Where the collision is due to what the machine makes of the path: what to do about that. */
Diagnostic
remedyFor(const std::vector<ToolPoses>&, const LeadCollision&)
{
  return "";
}

Diagnostic
remedyFor(const MachineProgram& program, const LeadCollision& deepest)
{
  const PoleZone* const zone = zoneOf(program, deepest);
  if (!zone)
    return "";
  return Diagnostic(
      "the tool axis is blended there by up to ", zone->largest_change * in_degrees,
      " {degrees}, because the rotary axis would turn too fast: keep the axis of the path ({ProgramSettings::pole_cone} 0), ");
}

/** A flank so long, from the centre of the ball, that the holder begins no nearer to the tip than the place of \p deepest is. */
Diagnostic
longerTool(const ToolWay& asked, const LeadCollision& deepest)
{
  const double length = (deepest.place - deepest.tip).norm() - asked.tool.cutter.radius + asked.tool.holder_clearance;
  if (!asked.is_ball || deepest.part != ToolPart::Holder || !(length > asked.tool.cutter.flank_length))
    return "";
  return Diagnostic(": ", Proposed("setFlankLength", length), " {mm} or more clears that place");
}

/** The whole scan without the clusters that are left out as false echoes. */
pcl::PointCloud<pcl::PointXYZ>::ConstPtr
obstaclesOf(const SpiralPlan& plan)
{
  if (plan.echoes.empty())
    return plan.whole;
  std::set<std::array<float, 3>> echoes;
  for (const Eigen::Vector3f& p : plan.echoes)
    echoes.insert({p.x(), p.y(), p.z()});
  const auto points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const pcl::PointXYZ& p : *plan.whole)
    if (echoes.count({p.x, p.y, p.z}) == 0)
      points->push_back(p);
  return points;
}

/** The points that the cutter stays off, and those that were left out by their place. */
pcl::PointCloud<pcl::PointXYZ>::ConstPtr
obstaclesOf(const PassPlan& plan)
{
  if (plan.chosen.beside.empty() && plan.chosen.kept_out.empty())
    return plan.cloud;
  const auto points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(*plan.cloud);
  for (const auto* some : {&plan.chosen.beside, &plan.chosen.kept_out})
    for (const Eigen::Vector3f& p : *some)
      points->emplace_back(p.x(), p.y(), p.z());
  return points;
}

template <typename Way>
Status
check(const ToolWay& asked, const Way& way, Diagnostics& warnings)
{
  HolderCheck<pcl::PointXYZ> check;
  if (asked.mesh)
    check.setInputMesh(asked.mesh);
  else
    check.setInputCloud(asked.points);
  check.setCutter(asked.tool.cutter);
  check.setHolder(asked.tool.holder);
  check.setHolderClearance(asked.tool.holder_clearance);
  check.setTolerance(asked.tool.tolerance);
  check.setLargestEcho(largest_echo);
  check.setNumberOfThreads(asked.tool.threads);
  check.setQuiet(true);
  check.setProgressCallback(asked.progress);
  check.compute(way);
  if (!check.getStatus().ok())
    return check.getStatus();
  const LeadReport &all = check.getReport(), &obstacles = check.getObstacleReport();
  const auto counted = [](const LeadReport& f) { return Diagnostic("; ", f.collided, " of the ", f.moves, " cutting moves collide"); };
  if (all.collided == 0)
    return Status::success();
  if (obstacles.collided == 0)
    warnings.push_back(collisionText(asked.tool, all.deepest) + counted(all) + only_echoes);
  else if (asked.tool.accepted)
    warnings.push_back(collisionText(asked.tool, obstacles.deepest) + counted(obstacles));
  else
    return {StatusCode::Failed,
            Diagnostic(collisionText(asked.tool, obstacles.deepest), counted(obstacles), ": ", remedyFor(way, obstacles.deepest),
                       asked.remedy, longerTool(asked, obstacles.deepest), ", or {setAcceptCollisions} to write the output anyway")};
  return Status::success();
}

} // namespace

Diagnostic
collisionText(const LedTool& tool, const LeadCollision& collision)
{
  const auto nameOfSegment = [&](std::size_t i) {
    const std::string& name = tool.holder[i].name;
    return name.empty() ? "segment " + std::to_string(i + 1) + " of the holder" : name;
  };
  const std::string what = collision.part == ToolPart::Cutter  ? "the cutter"
                           : collision.part == ToolPart::Shank ? "a shank as wide as the cutter"
                                                               : nameOfSegment(static_cast<std::size_t>(collision.segment));
  return Diagnostic(what, " would be ", collision.depth, " {mm} deep in the part ", wayOf(collision.section), ", at ",
                    Place(collision.place), ", the tip at ", Place(collision.tip));
}

ToolWay
wayOf(const SpiralPlan& plan)
{
  ToolWay way;
  way.tool = plan.tool;
  way.mesh = plan.whole_mesh;
  if (!way.mesh)
    way.points = obstaclesOf(plan);
  way.remedy = Diagnostic("lean the tool another way (", plan.settings.fixed_axis ? "{setFixedAxis}" : "{setTiltAngle}, {setLeadAngle}",
                          "), take a thinner {setHolder} or a longer tool ({setFlankLength})");
  way.is_ball = true;
  return way;
}

ToolWay
wayOf(const PassPlan& plan)
{
  ToolWay way;
  way.tool = plan.tool;
  way.mesh = plan.mesh;
  if (!way.mesh)
    way.points = obstaclesOf(plan);
  way.remedy = "use a longer or thinner tool, another axis";
  return way;
}

Status
checkToolWay(const ToolWay& way, const std::vector<ToolPoses>& passes, Diagnostics& warnings)
{
  return check(way, passes, warnings);
}

Status
checkToolWay(const ToolWay& way, const MachineProgram& program, Diagnostics& warnings)
{
  return check(way, program, warnings);
}

} // namespace pcl_spiral
