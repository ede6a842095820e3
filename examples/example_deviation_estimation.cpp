// SPDX-License-Identifier: BSD-3-Clause
// Deviation of a path from a scan: example_deviation_estimation SCAN.pcd PATH [MAP.pcd]
// PATH is a .csv, .pcd, .ply or .vtp toolpath; MAP holds its points with the deviation as intensity. Lengths in mm.
#include <pcl_spiral/io/toolpath_reader.h>
#include <pcl_spiral/verify/deviation_estimation.h>

#include <pcl/io/pcd_io.h>

#include <cstdio>
#include <exception>

int
main(int argc, char** argv)
{
  if (argc != 3 && argc != 4) {
    std::fprintf(stderr, "usage: %s SCAN.pcd PATH [MAP.pcd]\n", argv[0]);
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

  pcl_spiral::DeviationEstimation<pcl::PointXYZ> estimation;
  estimation.setInputCloud(scan);
  estimation.setInputToolpath(path);
  pcl::PointCloud<pcl::PointXYZI> map;
  estimation.compute(map);
  if (!estimation.getStatus().ok())
    return 1; // the class has reported the error

  const pcl_spiral::DeviationReport& f = estimation.getReport();
  for (const pcl_spiral::Diagnostic& warning : f.warnings)
    std::fprintf(stderr, "warning: %s\n", warning.text().c_str());
  std::printf("deviation: rms %.4f mm, p99 %.4f mm, greatest %.4f mm at point %zu\n", f.rms, f.p99, f.max.value, f.max.index);
  std::printf("normals: greatest error %.2f deg at point %zu\n", f.normal_error.value, f.normal_error.index);
  std::printf("scan: noise %.4f mm a point, %.4f mm in the surface fitted to it\n", f.noise, f.fit_noise);
  std::printf("motion: %.1f mm, longest move %.3f mm, sharpest turn %.2f deg, largest axis change %.2f deg\n", f.motion.length,
              f.motion.gap.value, f.motion.turn.value, f.motion.axis_change.value);
  return argc == 4 && pcl::io::savePCDFileBinary(argv[3], map) < 0 ? 1 : 0;
}
