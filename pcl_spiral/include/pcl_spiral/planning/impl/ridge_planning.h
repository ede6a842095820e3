// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From two measured lines, or a scan with rough points, to rows over a ridge.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/planning/ridge_plan.h>
#include <pcl_spiral/surface/surface_settings.h>

namespace pcl_spiral {

/** What is planned. */
struct RidgePlanInput {
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud; ///< the scan of the whole part; null: none
  pcl::PointCloud<pcl::Normal>::ConstPtr normals; ///< one for each point; null: none
  SurfaceSettings surface;                        ///< of the scan
  bool leave_out_strays = false;                  ///< points off the scanned surface are left out first
  Polyline rail, generator;                       ///< measured points; empty: found in the scan
  Polyline rough_points;                          ///< of the ridge in the scan
  bool closed = false;                            ///< the ridge in the scan is a ring
  double half_width = 0.0;                        ///< of the ridge in the scan
  RidgeSettings ridge;
  RidgeRowSettings rows;
  PassSettings tool;       ///< without a cutter a beam
  bool sample_mesh = true; ///< of a cutter without a scan: the plan has samples of the ridge, as checks of leads need them
  ProgressCallback progress;
};

/** Plans the rows. \p plan has no passes if the status is not ok. */
Status planRidge(const RidgePlanInput& input, RidgePlan& plan);

/** Triangles of \p ridge, whose curved surface is \p chord_error near it, mm. Fails if they would be too many. */
Status makeRidgeMesh(const RidgeSurface& ridge, double chord_error, SurfaceMesh::ConstPtr& mesh);

} // namespace pcl_spiral
