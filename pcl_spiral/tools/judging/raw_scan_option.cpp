// SPDX-License-Identifier: BSD-3-Clause
#include "raw_scan_option.h"

#include "terminal/scan_places.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/planning/impl/path_judging.h>

using namespace pcl_spiral;

RawScanReport
rawScanFigures(const std::string& file, const ReadOptions& read, const Surface& smoothed)
{
  RawScanReport figures;
  if (const Status status = compareRawScan(*readCloud(file, readAsScan(read)).cloud, smoothed, figures); !status.ok())
    throw FileError(file, status.diagnostic());
  return figures;
}
