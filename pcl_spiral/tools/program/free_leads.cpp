// SPDX-License-Identifier: BSD-3-Clause
#include "free_leads.h"
#include "terminal/terminal.h"

#include <pcl_spiral/cleaning/stray_removal.h>
#include <pcl_spiral/common/impl/message.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/verify/lead_check.h>

using namespace pcl_spiral;

namespace {

const char*
wayOf(BlockSection section)
{
  switch (section) {
  case BlockSection::Position:
    return "on its way over the part";
  case BlockSection::Approach:
    return "on its way down to the path";
  case BlockSection::LeadIn:
    return "in its lead to the path";
  case BlockSection::LeadOut:
    return "in its lead off the path";
  case BlockSection::Retract:
    return "on its way up from the path";
  default:
    return "while it unwinds";
  }
}

std::string
textOfCollision(const LedTool& tool, const LeadFigures& figures)
{
  const LeadCollision& deepest = figures.deepest;
  const std::string what = deepest.part == ToolPart::Cutter  ? "the cutter"
                           : deepest.part == ToolPart::Shank ? "a shank as wide as the cutter"
                                                             : tool.holder[static_cast<std::size_t>(deepest.segment)].name;
  return textOf(what, " would be ", deepest.depth, " mm deep in the part ", wayOf(deepest.section), ", at ", placeText(deepest.place),
                ", the tip at ", placeText(deepest.tip), "; ", figures.collided, " of ", figures.moves, " moves off the path do so");
}

LeadFigures
figuresOf(const std::string& scan_name, const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const pcl::IndicesConstPtr& indices,
          const LedTool& tool, const MachineProgram& program, ProgressBar& bar)
{
  LeadCheck<pcl::PointXYZ> check;
  check.setInputCloud(scan);
  if (indices)
    check.setIndices(indices);
  check.setCutter(tool.cutter);
  check.setHolder(tool.holder);
  check.setHolderClearance(tool.holder_clearance);
  check.setTolerance(tool.tolerance);
  check.setNumberOfThreads(tool.threads);
  check.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(share, stage); });
  check.compute(program);
  bar.clear();
  if (check.getStatus().code() == StatusCode::Cancelled || cancelled())
    throw Cancelled();
  if (!check.getStatus().ok())
    throw FileError(scan_name, check.getStatus().message());
  return check.getFigures();
}

/** The points but for those off the scanned surface that stand alone, as false echoes do; null where there are none, or none
 *  can be told from the others. */
pcl::IndicesPtr
withoutEchoes(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan)
{
  constexpr std::size_t most_together = 3;
  StrayRemoval<pcl::PointXYZ> removal;
  removal.setLargestGroup(most_together);
  removal.setInputCloud(scan);
  const pcl::IndicesPtr kept = pcl::make_shared<pcl::Indices>();
  removal.filter(*kept);
  return removal.getStatus().ok() && kept->size() < scan->size() ? kept : nullptr;
}

} // namespace

void
requireFreeLeads(const std::string& scan_name, const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const LedTool& tool,
                 const MachineProgram& program, bool accepted, bool quiet, std::vector<std::string>& warnings)
{
  ProgressBar bar(quiet);
  const LeadFigures all = figuresOf(scan_name, scan, nullptr, tool, program, bar);
  if (all.collided == 0)
    return;
  LeadFigures figures = all;
  if (const pcl::IndicesPtr kept = withoutEchoes(scan))
    figures = figuresOf(scan_name, scan, kept, tool, program, bar);
  if (figures.collided == 0) {
    warnings.push_back(textOfCollision(tool, all) +
                       ": only single points off the scanned surface, false echoes as a rule, stand there; see that nothing else does");
    return;
  }
  if (accepted) {
    warnings.push_back(textOfCollision(tool, figures));
    return;
  }
  throw FileError(scan_name, textOfCollision(tool, figures) +
                                 ": lean the tool axis another way, take another --lead-in or --lead-length, a "
                                 "slimmer or longer tool, or --accept-collisions to see the program all the same");
}
