// SPDX-License-Identifier: BSD-3-Clause
#include "library_stages.h"

namespace pcl_spiral::benchmarks {

namespace {

template <FileOrder order>
void
normalsOfPcl(benchmark::State& state, StageInput& input, int threads)
{
  const Cloud::ConstPtr& cloud = input.cloud(order);
  for (auto _ : state)
    benchmark::DoNotOptimize(test::pclNormals(cloud, test::Tree::Ptr(new test::Tree), threads));
  count(state, cloud->size(), cloud->size() * sizeof(pcl::PointXYZ));
}

/** With the tree from the normals. */
template <FileOrder order>
void
boundaryOfPcl(benchmark::State& state, StageInput& input, int)
{
  const Cloud::ConstPtr& cloud = input.cloud(order);
  const test::NormalCloud::ConstPtr& normals = input.normals(order);
  const test::Tree::Ptr& tree = input.tree(order);
  for (auto _ : state)
    benchmark::DoNotOptimize(test::pclBoundary(cloud, normals, tree));
  count(state, cloud->size(), cloud->size() * sizeof(pcl::PointXYZ));
}

} // namespace

std::vector<Stage>
pclStages()
{
  return {{"pcl_normals", normalsOfPcl<FileOrder::Random>},
          {"pcl_boundary", boundaryOfPcl<FileOrder::Random>, false},
          {"pcl_normals_sorted_file", normalsOfPcl<FileOrder::Sorted>},
          {"pcl_boundary_sorted_file", boundaryOfPcl<FileOrder::Sorted>, false}};
}

} // namespace pcl_spiral::benchmarks
