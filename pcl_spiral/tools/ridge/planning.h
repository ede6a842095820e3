// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From two measured lines, or a scan, to rows of a tool.
 */
#pragma once

#include "job.h"
#include "passes/pass_result.h"

#include <pcl_spiral/ridge/impl/ridge_lines_engine.h>
#include <pcl_spiral/ridge/ridge_rows.h>
#include <pcl_spiral/ridge/ridge_surface.h>

#include <optional>

/** All that a run came to. Without a cutter the mesh is of the ridge, and made for pictures alone. */
struct Result : PassResult {
  pcl_spiral::Polyline rail, generator; ///< measured points, or those found in the scan
  pcl_spiral::RidgeSurface::ConstPtr ridge;
  std::optional<pcl_spiral::ScanRidgeReport> found; ///< where both lines were found in a scan
  pcl_spiral::RidgeRowReport rows;
};

/** Reads the lines or finds them, makes the rows, locates the cutter. \throw UsageError, pcl_spiral::FileError, Cancelled */
Result plan(const Job& job);
