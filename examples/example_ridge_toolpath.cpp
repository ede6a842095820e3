// SPDX-License-Identifier: BSD-3-Clause
// Rows of a laser spot over a ridge with two measured lines: along it, and once across.
// Usage: example_ridge_toolpath RAIL GENERATOR
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/ridge/ridge_toolpath.h>

#include <cstdio>
#include <exception>

int
main(int argc, char** argv)
try {
  if (argc != 3)
    return std::fprintf(stderr, "usage: example_ridge_toolpath RAIL GENERATOR\n"), 2;
  pcl_spiral::RidgeToolpath<pcl::PointXYZ> ridge;
  ridge.setInputCloud(pcl_spiral::readCloud(argv[1]).cloud);
  ridge.setInputGenerator(pcl_spiral::readCloud(argv[2]).cloud);
  ridge.setSpot(4.0, 0.25);   // mm, share that the next row covers again
  ridge.setStandOff(10.0);    // mm
  ridge.setPointSpacing(0.5); // mm
  ridge.setQuiet(true);
  pcl_spiral::DrivePasses rows;
  ridge.compute(rows);
  if (!ridge.getStatus().ok())
    return std::fprintf(stderr, "%s\n", ridge.getStatus().message().c_str()), 1;

  const pcl_spiral::RidgeReport& found = ridge.getRidge()->report();
  std::printf("rail %.1f mm, generator %.2f mm, measured to %.3f and %.3f mm; its chord keeps %.2f degrees\n", found.rail_length,
              found.generator_length, found.rail_error, found.generator_error, found.chord_angle);
  for (const pcl_spiral::Diagnostic& warning : found.warnings)
    std::printf("warning: %s\n", warning.text().c_str());
  std::printf("%zu rows, %.2f mm apart, %zu points, %.1f mm\n", ridge.getReport().rows, ridge.getReport().largest_step,
              ridge.getReport().points, ridge.getReport().length);
  const pcl_spiral::DrivePoint& first = rows.front().points.front();
  std::printf("begins at (%.3f, %.3f, %.3f), axis (%.4f, %.4f, %.4f)\n", first.position.x(), first.position.y(), first.position.z(),
              first.axis.x(), first.axis.y(), first.axis.z());
  return 0;
}
catch (const std::exception& error) {
  return std::fprintf(stderr, "example_ridge_toolpath: %s\n", error.what()), 1;
}
