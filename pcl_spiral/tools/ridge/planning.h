// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Makes rows of a tool from two measured lines or a scan.
 */
#pragma once

#include "job.h"
#include "passes/pass_result.h"

#include <pcl_spiral/ridge/impl/ridge_lines_engine.h>
#include <pcl_spiral/ridge/ridge_rows.h>
#include <pcl_spiral/ridge/ridge_surface.h>

#include <optional>

/** The result of a run. Without a cutter the mesh is of the ridge, and only for pictures. */
struct Result : PassResult {
  pcl_spiral::Polyline rail, generator; ///< measured points, or those found in the scan
  pcl_spiral::RidgeSurface::ConstPtr ridge;
  std::optional<pcl_spiral::ScanRidgeReport> found; ///< if both lines were found in a scan
  pcl_spiral::RidgeRowReport rows;
};

/** Reads or finds the lines, makes the rows, finds the cutter locations. \throw UsageError, pcl_spiral::FileError, Cancelled */
Result plan(const Job& job);
