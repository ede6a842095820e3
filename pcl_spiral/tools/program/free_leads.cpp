// SPDX-License-Identifier: BSD-3-Clause
#include "free_leads.h"
#include "terminal/terminal.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/verify/lead_check.h>

using namespace pcl_spiral;

namespace {

Diagnostic
textOfCollision(const LedTool& tool, const LeadFigures& figures)
{
  return Diagnostic(collisionText(tool, figures.deepest), "; ", figures.collided, " of the ", figures.moves, " moves off the path collide");
}

} // namespace

LeadCheck<pcl::PointXYZ>
leadCheckOf(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const LedTool& tool)
{
  LeadCheck<pcl::PointXYZ> check;
  check.setInputCloud(scan);
  check.setCutter(tool.cutter);
  check.setHolder(tool.holder);
  check.setHolderClearance(tool.holder_clearance);
  check.setTolerance(tool.tolerance);
  check.setLargestEcho(largest_echo);
  check.setNumberOfThreads(tool.threads);
  return check;
}

void
requireFreeLeads(const std::string& scan_name, const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const LedTool& tool,
                 const MachineProgram& program, bool accepted, bool quiet, Diagnostics& warnings)
{
  ProgressBar bar(quiet);
  LeadCheck<pcl::PointXYZ> check = leadCheckOf(scan, tool);
  check.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(share, stage); });
  check.compute(program);
  bar.clear();
  if (check.getStatus().code() == StatusCode::Cancelled || cancelled())
    throw Cancelled();
  if (!check.getStatus().ok())
    throw FileError(scan_name, check.getStatus().diagnostic());
  const LeadFigures &all = check.getFigures(), &obstacles = check.getObstacleFigures();
  if (all.collided == 0)
    return;
  if (obstacles.collided == 0)
    warnings.push_back(textOfCollision(tool, all) + only_echoes);
  else if (accepted)
    warnings.push_back(textOfCollision(tool, obstacles));
  else
    throw FileError(scan_name, Diagnostic(textOfCollision(tool, obstacles),
                                          ": lean the tool axis another way, take another --lead-in or --lead-length, a "
                                          "slimmer or longer tool, or --accept-collisions to write the output anyway"));
}
