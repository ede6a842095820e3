// SPDX-License-Identifier: BSD-3-Clause
#include "planning/pass_mesh.h"

#include "mesh/mesh_findings.h"
#include <pcl_spiral/mesh/mesh_sampling.h>

#include <pcl/common/io.h>

#include <algorithm>

namespace pcl_spiral {

void
warnOfMesh(PassPlan& plan)
{
  const MeshReport& counts = plan.mesh->report();
  if (const Diagnostic found = findingsText(counts); !found.empty())
    plan.warnings.push_back(Diagnostic("the mesh: ", found));
  if (counts.creases.count > 0)
    plan.warnings.push_back(Diagnostic("the mesh has ", counts.crease_length, " {mm} of creases (edges bent by more than ",
                                       plan.mesh->settings().crease_angle, " {degrees}), the first at ", Place(counts.creases.place),
                                       ": they stay sharp; if the part is round there, increase {MeshSettings::crease_angle}"));
}

Status
sampleMesh(double radius, unsigned int threads, PassPlan& plan)
{
  constexpr double share = 0.3; // of the cutter's radius: the sag between points is a hundredth of the radius
  MeshSampling sampling;
  sampling.setInputMesh(plan.mesh);
  sampling.setNumberOfThreads(threads);
  sampling.setSpacing(std::min(defaultSampleSpacing(*plan.mesh), share * radius));
  pcl::PointCloud<pcl::PointNormal> samples;
  sampling.compute(samples);
  if (!sampling.getStatus().ok())
    return sampling.getStatus();
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  pcl::copyPointCloud(samples, *cloud);
  plan.whole = plan.cloud = cloud;
  return Status::success();
}

} // namespace pcl_spiral
