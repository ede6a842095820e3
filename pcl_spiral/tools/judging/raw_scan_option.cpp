// SPDX-License-Identifier: BSD-3-Clause
#include "raw_scan_option.h"

#include "terminal/scan_places.h"

#include <pcl_spiral/io/file_error.h>

using namespace pcl_spiral;

const char* const raw_scan_help =
    "the scan before it was smoothed: says what smoothing moved, and the path must not cut into its points: --raw-scan raw.pcd";

RawScanFigures
rawScanFigures(const std::string& file, const ReadOptions& read, const Surface& smoothed)
{
  const Scan raw = readCloud(file, readAsScan(read));
  std::vector<Eigen::Vector3f> points;
  for (const pcl::PointXYZ& p : *raw.cloud)
    points.push_back(p.getVector3fMap());
  RawScanFigures figures = compareWithRaw(smoothed, points);
  if (figures.points == 0)
    throw FileError(file, smoothingText(figures, file));
  return figures;
}
