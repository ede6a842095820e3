// SPDX-License-Identifier: BSD-3-Clause
// Makes rows of a laser spot over a ridge from a scan of the part and a few rough points on the ridge.
// Usage: example_ridge_lines SCAN HALF_WIDTH X Y Z X Y Z ...
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/ridge/ridge_lines.h>
#include <pcl_spiral/ridge/ridge_toolpath.h>

#include <cstdio>
#include <cstdlib>
#include <exception>

int
main(int argc, char** argv)
try {
  if (argc < 9 || argc % 3 != 0)
    return std::fprintf(stderr, "usage: example_ridge_lines SCAN HALF_WIDTH X Y Z X Y Z ...\n"), 2;
  pcl_spiral::Polyline rough;
  for (int i = 3; i < argc; i += 3)
    rough.emplace_back(std::atof(argv[i]), std::atof(argv[i + 1]), std::atof(argv[i + 2]));
  pcl_spiral::RidgeLines<pcl::PointXYZ> lines;
  lines.setInputCloud(pcl_spiral::readCloud(argv[1]).cloud);
  lines.setHalfWidth(std::atof(argv[2])); // mm, to either side of the crest
  lines.setRoughPoints(rough);            // at both ends, and between them where the ridge bends
  lines.setQuiet(true);
  const pcl::PointCloud<pcl::PointXYZ>::Ptr rail(new pcl::PointCloud<pcl::PointXYZ>), generator(new pcl::PointCloud<pcl::PointXYZ>);
  lines.compute(*rail, *generator);
  if (!lines.getStatus().ok())
    return std::fprintf(stderr, "%s\n", lines.getStatus().message().c_str()), 1;
  const pcl_spiral::ScanRidgeReport& found = lines.getReport();
  std::printf("%zu sections, off by %.4f mm rms, %.4f at most; the scan scatters by %.4f\n", found.sections, found.misfit,
              found.largest_misfit, found.noise);
  for (const pcl_spiral::Diagnostic& warning : found.warnings)
    std::printf("warning: %s\n", warning.text().c_str());

  pcl_spiral::RidgeToolpath<pcl::PointXYZ> ridge;
  ridge.setInputCloud(rail);
  ridge.setInputGenerator(generator);
  ridge.setFlipNormals(lines.getRidge()->settings().flip); // up is the side of the scanner
  ridge.setSpot(4.0, 0.25);                                // mm, share that the next row covers again
  ridge.setQuiet(true);
  pcl_spiral::DrivePasses rows;
  ridge.compute(rows);
  if (!ridge.getStatus().ok())
    return std::fprintf(stderr, "%s\n", ridge.getStatus().message().c_str()), 1;
  std::printf("%zu rows, %.2f mm apart, %zu points, %.1f mm\n", ridge.getReport().rows, ridge.getReport().largest_step,
              ridge.getReport().points, ridge.getReport().length);
  return 0;
}
catch (const std::exception& error) {
  return std::fprintf(stderr, "example_ridge_lines: %s\n", error.what()), 1;
}
