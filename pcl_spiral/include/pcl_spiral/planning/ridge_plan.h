// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Rows of a beam or a cutter over a ridge, with all that they were made from.
 */
#pragma once

#include <pcl_spiral/planning/pass_plan.h>
#include <pcl_spiral/ridge/impl/ridge_lines_engine.h>
#include <pcl_spiral/ridge/ridge_rows.h>
#include <pcl_spiral/ridge/ridge_surface.h>

#include <optional>

namespace pcl_spiral {

/** What a ridge was planned from when it failed. */
enum class RidgeFault {
  Scan,  ///< the scan, as a surface or as what holds the ridge
  Lines, ///< the measured lines
  Rows   ///< rows and locations
};

/** Lines and rows of a ridge. Lengths in mm. */
struct RidgePlanReport {
  Polyline rail;                        ///< measured points, or those found in the scan
  Polyline generator;                   ///< the same of the other line
  RidgeSurface::ConstPtr ridge;         ///< null if it could not be made
  std::optional<ScanRidgeReport> found; ///< if both lines were found in the scan
  RidgeRowReport rows;                  ///< its warnings are in those of the plan
};

/** \deprecated Use RidgePlanReport. */
using RidgeFigures [[deprecated("use RidgePlanReport")]] = RidgePlanReport;

/** Passes over a ridge: each is a row. */
struct RidgePlan : PassPlan, RidgePlanReport {
  RidgeFault fault = RidgeFault::Scan; ///< of a plan that failed: where
};

} // namespace pcl_spiral
