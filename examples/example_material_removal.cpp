// SPDX-License-Identifier: BSD-3-Clause
// Stock that a ball cutter leaves on a scan: example_material_removal SCAN.pcd PATH TOOL_RADIUS SCALLOP_HEIGHT [MAP.pcd]
// PATH is a .csv, .pcd, .ply or .vtp toolpath; MAP holds the scan with stock (+) or gouge (-) as intensity. In mm.
#include <pcl_spiral/io/toolpath_reader.h>
#include <pcl_spiral/verify/material_removal.h>

#include <pcl/io/pcd_io.h>

#include <cstdio>
#include <cstdlib>
#include <exception>

int
main(int argc, char** argv)
{
  if (argc != 5 && argc != 6) {
    std::fprintf(stderr, "usage: %s SCAN.pcd PATH TOOL_RADIUS SCALLOP_HEIGHT [MAP.pcd]\n", argv[0]);
    return 2;
  }
  pcl::PointCloud<pcl::PointXYZ>::Ptr scan(new pcl::PointCloud<pcl::PointXYZ>);
  pcl::PointCloud<pcl_spiral::ToolpathPoint>::Ptr path(new pcl::PointCloud<pcl_spiral::ToolpathPoint>);
  if (pcl::io::loadPCDFile(argv[1], *scan) < 0)
    return 1; // the class has reported the error
  try {
    *path = pcl_spiral::readToolpath(argv[2]).path;
  }
  catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }

  pcl_spiral::MaterialRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(scan);
  removal.setInputToolpath(path);
  removal.setToolRadius(std::atof(argv[3]));
  removal.setScallopHeight(std::atof(argv[4]));
  pcl::PointCloud<pcl::PointXYZI> map;
  removal.compute(map);
  if (!removal.getStatus().ok())
    return 1; // the class has reported the error

  const pcl_spiral::RemovalReport& f = removal.getReport();
  for (const pcl_spiral::Diagnostic& warning : f.warnings)
    std::fprintf(stderr, "warning: %s\n", warning.text().c_str());
  std::printf("scallop: p50 %.4f, p99 %.4f, p99.9 %.4f, greatest %.4f mm; above %.4f mm: %.2f %%\n", f.scallop.p50, f.scallop.p99,
              f.scallop.p999, f.scallop.max.value, f.limit, 100.0 * f.scallop.share_above);
  std::printf("gouge: %.4f mm at path point %zu; uncut: %.2f %%\n", f.gouge.value, f.gouge.index, 100.0 * f.stock.uncutShare());
  std::printf("length: %.1f mm, %.1f %% efficient\n", f.path_length, 100.0 * f.efficiency);
  return argc == 6 && pcl::io::savePCDFileBinary(argv[5], map) < 0 ? 1 : 0;
}
