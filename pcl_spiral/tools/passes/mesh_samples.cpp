// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_samples.h"

#include "scan_surface.h"

#include <pcl_spiral/mesh/mesh_sampling.h>

#include <pcl/common/io.h>

#include <algorithm>

using namespace pcl_spiral;

void
sampleMesh(const PassJob& job, PassResult& result)
{
  constexpr double share = 0.3; // of the cutter's radius: the sag between points is a hundredth of the radius
  MeshSampling sampling;
  sampling.setInputMesh(result.mesh);
  sampling.setNumberOfThreads(job.threads);
  sampling.setSpacing(std::min(defaultSampleSpacing(*result.mesh), share * job.cutter.radius));
  pcl::PointCloud<pcl::PointNormal> samples;
  sampling.compute(samples);
  require(job.part, sampling.getStatus());
  result.scan.cloud.reset(new pcl::PointCloud<pcl::PointXYZ>);
  pcl::copyPointCloud(samples, *result.scan.cloud);
  result.whole_scan = result.scan.cloud;
}
