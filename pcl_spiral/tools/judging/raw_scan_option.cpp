// SPDX-License-Identifier: BSD-3-Clause
#include "raw_scan_option.h"

#include "terminal/scan_places.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/file_error.h>

using namespace pcl_spiral;

RawScanFigures
rawScanFigures(const std::string& file, const ReadOptions& read, const Surface& smoothed)
{
  const Scan raw = readCloud(file, readAsScan(read));
  std::vector<Eigen::Vector3f> points;
  for (const pcl::PointXYZ& p : *raw.cloud)
    points.push_back(p.getVector3fMap());
  RawScanFigures figures = compareWithRaw(smoothed, points);
  if (points.empty() || 2 * figures.points < points.size())
    throw FileError(file, Diagnostic(points.size() - figures.points, " of ", points.size(),
                                     " points of this raw scan have no smoothed surface near: is it another part, another unit, or are its "
                                     "columns others?"));
  return figures;
}
