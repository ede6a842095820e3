// SPDX-License-Identifier: BSD-3-Clause
// A spiral from an STL file: samples of the curved surface behind the faces, and the distance of contacts from the exact surface.
#include "mesh/mesh_findings.h"
#include <pcl_spiral/io/mesh_reader.h>
#include <pcl_spiral/mesh/mesh_sampling.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include "support/meshes.h"
#include "support/scratch_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mesh_spiral_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

TEST(MeshSpiral, ContactsLieOnTheExactLandform)
{
  const SurfacePtr surface = landform();
  ScratchFolder folder;
  writeStl(folder.path("landform.stl"), gridMesh(*surface, {100, 100}, 49));
  const MeshFile file = readMesh(folder.path("landform.stl"));
  MeshSampling sampling;
  sampling.setInputMesh(file.mesh);
  const auto samples = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  sampling.compute(*samples);
  ASSERT_TRUE(sampling.getStatus().ok()) << sampling.getStatus().message();
  EXPECT_EQ(findingsText(sampling.getSurfaceMesh()->report()), "");
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  for (const pcl::PointNormal& sample : *samples)
    normals->emplace_back(sample.normal_x, sample.normal_y, sample.normal_z);
  SpiralToolpathGenerator<pcl::PointNormal> generator;
  generator.setInputCloud(samples);
  generator.setInputNormals(normals);
  generator.setToolRadius(5.0);
  generator.setScallopHeight(0.01);
  generator.setChordError(0.001);
  pcl::PointCloud<ToolpathPoint> path;
  generator.compute(path);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  EXPECT_TRUE(generator.getReport().warnings.empty()) << generator.getReport().warnings.front();
  std::vector<double> off;
  for (const ToolpathPoint& p : path)
    off.push_back(std::abs(surface->signedDistance(p.getVector3fMap().cast<double>())));
  std::sort(off.begin(), off.end());
  EXPECT_LE(off[off.size() * 99 / 100], 0.004);
  EXPECT_LE(off.back(), 0.015);
}

TEST(MeshSpiral, FindingsAreReportedInOneLine)
{
  MeshReport counts;
  counts.parts = 1;
  EXPECT_EQ(findingsText(counts), "");
  counts.turned.add({1.0, 2.5, 0.0});
  counts.turned.add({7.0, 0.0, 0.0});
  counts.crowded_edges.add({0.0, 0.0, 3.0});
  counts.parts = 2;
  EXPECT_EQ(findingsText(counts), "2 faces turned (first at (1, 2.5, 0)), 1 edges of more than two faces cut open (first at (0, 0, 3)), "
                                  "2 separate parts");
}

} // namespace mesh_spiral_test
