// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What one run of pcl_spiral_ridge is asked to do.
 */
#pragma once

#include "passes/pass_job.h"

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/ridge/ridge_rows.h>
#include <pcl_spiral/ridge/ridge_surface.h>

#include <string>

/** A run as the user described it. Lengths mm, angles degrees. Without a cutter the tool is a beam. */
struct Job : PassJob {
  std::string rail, generator;  ///< files; empty where both are looked for in the scan
  pcl_spiral::Polyline through; ///< rough points of the ridge in the scan
  bool ring = false;            ///< the ridge in the scan is closed
  double half_width = 0.0;      ///< of the ridge in the scan, from the crest to either side
  pcl_spiral::RidgeSettings ridge;
  pcl_spiral::RidgeRowSettings rows;
  double scallop = 0.0;
  bool one_way = false;

  bool hasCutter() const { return cutter.radius > 0.0; }
};
