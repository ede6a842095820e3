// SPDX-License-Identifier: BSD-3-Clause
#include "free_passes.h"

#include "pass_check.h"
#include "program/free_path.h"

using namespace pcl_spiral;

namespace {

/** The points that the cutter stays off, and those that were left out by their place. */
pcl::PointCloud<pcl::PointXYZ>::ConstPtr
obstaclesOf(const PassResult& result)
{
  if (result.chosen.beside.empty() && result.chosen.kept_out.empty())
    return result.scan.cloud;
  const auto points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(*result.scan.cloud);
  for (const auto* some : {&result.chosen.beside, &result.chosen.kept_out})
    for (const Eigen::Vector3f& p : *some)
      points->emplace_back(p.x(), p.y(), p.z());
  return points;
}

PathCheck
checkOf(const PassJob& job, const PassResult& result)
{
  PathCheck check;
  check.file = job.part;
  check.tool = {job.cutter, job.holder, job.holder_clearance, job.tolerance + result.locations.noise_allowance, job.threads};
  check.mesh = result.mesh;
  if (!check.mesh)
    check.points = obstaclesOf(result);
  check.remedy = "use a longer or thinner tool, another axis";
  check.accepted = job.program.accept_collisions;
  check.quiet = job.quiet;
  return check;
}

} // namespace

void
requireFreePasses(const PassJob& job, PassResult& result)
{
  if (!job.holder.empty())
    requireFreePath(checkOf(job, result), result.passes, result.warnings);
}

void
requireFreeProgram(const PassJob& job, PassResult& result)
{
  if (!isGiven(job, "no-gouge-check"))
    requireFreePath(checkOf(job, result), *result.program, result.warnings);
}
