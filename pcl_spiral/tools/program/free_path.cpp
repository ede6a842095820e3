// SPDX-License-Identifier: BSD-3-Clause
#include "free_path.h"
#include "terminal/terminal.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/verify/holder_check.h>

#include <algorithm>

using namespace pcl_spiral;

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
  return Diagnostic("the tool axis is blended there by up to ", zone->largest_change * in_degrees,
                    " degrees, because the rotary axis would turn too fast: keep the axis of the path (--pole-cone 0), ");
}

template <typename Way>
void
requireFree(const PathCheck& asked, const Way& way, Diagnostics& warnings)
{
  ProgressBar bar(asked.quiet);
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
  check.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(share, stage); });
  check.compute(way);
  bar.clear();
  if (check.getStatus().code() == StatusCode::Cancelled || cancelled())
    throw Cancelled();
  if (!check.getStatus().ok())
    throw FileError(asked.file, check.getStatus().diagnostic());
  const LeadFigures &all = check.getFigures(), &obstacles = check.getObstacleFigures();
  const auto counted = [](const LeadFigures& f) { return Diagnostic("; ", f.collided, " of the ", f.moves, " cutting moves collide"); };
  if (all.collided == 0)
    return;
  if (obstacles.collided == 0)
    warnings.push_back(collisionText(asked.tool, all.deepest) + counted(all) + only_echoes);
  else if (asked.accepted)
    warnings.push_back(collisionText(asked.tool, obstacles.deepest) + counted(obstacles));
  else
    throw FileError(asked.file,
                    Diagnostic(collisionText(asked.tool, obstacles.deepest), counted(obstacles), ": ", remedyFor(way, obstacles.deepest),
                               asked.remedy, ", or --accept-collisions to write the output anyway"));
}

} // namespace

void
requireFreePath(const PathCheck& check, const std::vector<ToolPoses>& passes, Diagnostics& warnings)
{
  requireFree(check, passes, warnings);
}

void
requireFreePath(const PathCheck& check, const MachineProgram& program, Diagnostics& warnings)
{
  requireFree(check, program, warnings);
}
