// SPDX-License-Identifier: BSD-3-Clause
#include "holder_way.h"

#include "program/free_path.h"

#include <pcl_spiral/collision/impl/way_check.h>
#include <pcl_spiral/machine/machine_program_generator.h>

#include <array>
#include <set>

using namespace pcl_spiral;

namespace {

/** The whole scan without the clusters that are left out as false echoes. */
pcl::PointCloud<pcl::PointXYZ>::ConstPtr
obstaclesOf(const Result& result)
{
  if (result.echoes.empty())
    return result.whole_scan;
  std::set<std::array<float, 3>> echoes;
  for (const Eigen::Vector3f& p : result.echoes)
    echoes.insert({p.x(), p.y(), p.z()});
  const auto points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const pcl::PointXYZ& p : *result.whole_scan)
    if (echoes.count({p.x, p.y, p.z}) == 0)
      points->push_back(p);
  return points;
}

template <typename Way>
void
check(const Job& job, const Way& way, Result& result)
{
  PathCheck asked;
  asked.file = job.scan;
  asked.tool = toolOf(job, result.report);
  asked.mesh = result.whole_mesh;
  if (!asked.mesh)
    asked.points = obstaclesOf(result);
  asked.remedy = Diagnostic("lean the tool another way (", job.settings.fixed_axis ? "--axis" : "--tilt, --lead",
                            "), take a longer tool (--flank-length) or a thinner --holder");
  asked.accepted = job.program.accept_collisions;
  asked.quiet = job.quiet;
  requireFreePath(asked, way, result.report.warnings);
}

} // namespace

LedTool
toolOf(const Job& job, const SpiralReport& report)
{
  LedTool tool;
  tool.cutter = CutterShape::ball(job.settings.tool_radius, job.flank_length);
  tool.holder = job.holder;
  tool.holder_clearance = job.holder_clearance;
  tool.tolerance = gougeTolerance(job.settings.chord_error, report.noise);
  tool.threads = job.settings.threads;
  return tool;
}

void
checkHolder(const Job& job, Result& result)
{
  if (job.holder.empty())
    return;
  StageClock clock(result.report.stages);
  check(job, ballPasses(*result.path, job.settings.tool_radius), result);
  clock.end("holder");
}

void
checkHolder(const Job& job, const MachineProgram& program, Result& result)
{
  if (!job.holder.empty())
    check(job, program, result);
}
