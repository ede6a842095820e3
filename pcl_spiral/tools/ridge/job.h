// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The user's settings for one run of pcl_spiral_ridge.
 */
#pragma once

#include "passes/pass_job.h"

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/ridge/ridge_rows.h>
#include <pcl_spiral/ridge/ridge_surface.h>

#include <string>

/** The user's settings for one run. Lengths in mm, angles in degrees. Without a cutter the tool is a beam. */
struct Job : PassJob {
  std::string rail, generator;  ///< files; empty if both are found in the scan
  pcl_spiral::Polyline through; ///< rough points of the ridge in the scan
  bool ring = false;            ///< the ridge in the scan is closed
  double half_width = 0.0;      ///< of the ridge in the scan, from the crest to each side
  pcl_spiral::RidgeSettings ridge;
  pcl_spiral::RidgeRowSettings rows;
  double scallop = 0.0;
  bool one_way = false;

  bool hasCutter() const { return cutter.radius > 0.0; }
};
