// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The option --raw-scan: the scan before it was smoothed.
 */
#pragma once

#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/verify/raw_scan.h>

#include <string>

/** The raw scan \p file beside \p smoothed, read as the scan was read with \p read.
 *  \throw pcl_spiral::FileError as readCloud, and if most of its points are not near the smoothed surface */
pcl_spiral::RawScanReport rawScanFigures(const std::string& file, const pcl_spiral::ReadOptions& read, const pcl_spiral::Surface& smoothed);
