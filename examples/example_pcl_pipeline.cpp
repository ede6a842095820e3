// SPDX-License-Identifier: BSD-3-Clause
// From a raw cloud to a path in a PLY file, all steps in PCL's own terms: filters, features, search, surfaces.
#include <pcl_spiral/features/centroid_boundary_estimation.h>
#include <pcl_spiral/geodesic/geodesic_path.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/surface/mls_projector.h>

#include <pcl/features/normal_3d_omp.h>
#include <pcl/filters/extract_indices.h>
#include <pcl/filters/passthrough.h>
#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <iostream>

using Point = pcl::PointXYZ;
using Cloud = pcl::PointCloud<Point>;

/** Runs a filter of PCL on \p cloud. */
template <typename Filter>
Cloud::Ptr
filtered(Filter& filter, const Cloud::ConstPtr& cloud)
{
  Cloud::Ptr output(new Cloud);
  filter.setInputCloud(cloud);
  filter.filter(*output);
  return output;
}

int
main(int argc, char** argv)
{
  Cloud::Ptr scan(new Cloud);
  if (argc != 3 || pcl::io::loadPCDFile(argv[1], *scan) != 0)
    return 2;
  pcl::PassThrough<Point> pass;
  pass.setFilterFieldName("z");
  pass.setFilterLimits(-1000.0f, 1000.0f);
  pcl::StatisticalOutlierRemoval<Point> outliers;
  outliers.setMeanK(16);
  outliers.setStddevMulThresh(3.0);
  pcl::VoxelGrid<Point> grid;
  grid.setLeafSize(0.5f, 0.5f, 0.5f);
  const Cloud::Ptr clean = filtered(grid, filtered(outliers, filtered(pass, scan)));

  pcl::NormalEstimationOMP<Point, pcl::Normal> estimation;
  estimation.setInputCloud(clean);
  estimation.setViewPoint(0.0f, 0.0f, 1000.0f); // where the cutter comes from
  estimation.setKSearch(24);
  const pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  estimation.compute(*normals);

  pcl_spiral::CentroidBoundaryEstimation<Point, pcl::Normal> centroid;
  pcl::BoundaryEstimation<Point, pcl::Normal, pcl::Boundary>& boundary = centroid;
  boundary.setInputCloud(clean);
  boundary.setInputNormals(normals);
  boundary.setKSearch(32);
  pcl::PointCloud<pcl::Boundary> marks;
  boundary.compute(marks);
  const pcl::IndicesPtr rim(new pcl::Indices);
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (marks[i].boundary_point != 0)
      rim->push_back(static_cast<pcl::index_t>(i));
  pcl::ExtractIndices<Point> extract;
  extract.setIndices(rim);
  std::cout << filtered(extract, clean)->size() << " boundary points\n";

  pcl_spiral::GeodesicPath<Point> geodesic;
  geodesic.setInputCloud(clean);
  geodesic.setSourceIndex(0);
  geodesic.setTargetIndices({static_cast<pcl::index_t>(clean->size() - 1)});
  std::vector<Cloud> lines;
  geodesic.compute(lines);
  std::cout << "shortest path on the surface: " << lines.front().size() << " points\n";

  pcl_spiral::MLSProjector<Point, pcl::PointNormal> projector;
  pcl::CloudSurfaceProcessing<Point, pcl::PointNormal>& processing = projector;
  processing.setInputCloud(clean);
  processing.setIndices(rim); // queries; all points support the surface
  pcl::PointCloud<pcl::PointNormal> feet;
  processing.process(feet);
  std::cout << feet.size() << " feet\n";

  pcl_spiral::SpiralToolpathGenerator<Point, pcl::Normal, pcl::PointNormal> spiral;
  spiral.setInputCloud(clean);
  spiral.setInputNormals(normals);
  spiral.setToolRadius(10.0);
  spiral.setScallopHeight(0.05);
  pcl::PointCloud<pcl::PointNormal> path;
  spiral.compute(path);
  std::cout << spiral.getStatus().message() << ", " << path.size() << " points of the path\n";
  return spiral.getStatus().ok() && pcl::io::savePLYFileBinary(argv[2], path) == 0 ? 0 : 1;
}
