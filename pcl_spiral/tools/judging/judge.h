// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Judges a toolpath by a scan or a mesh.
 */
#pragma once

#include "terminal/scan_side.h"
#include "verify/verification.h"
#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/verify/deviation_estimation.h>

/** Settings for judging a path. */
struct JudgeSettings {
  pcl_spiral::CutterShape cutter;                 ///< radius 0: not given
  pcl_spiral::Polyline tips;                      ///< of the path, one per point; empty: from its contacts
  double scallop_height = 0.0, chord_error = 0.0; ///< mm
  ScanSide side;                                  ///< what decides the side of the scan
  bool flip_normals = false;
  unsigned int threads = 0;
  pcl_spiral::Surface::ConstPtr surface;            ///< of the scan, if it exists already; null: it is made
  pcl_spiral::SurfaceMesh::ConstPtr mesh = nullptr; ///< to judge by instead of a scan; null: by the scan
  double sample_spacing = 0.0;                      ///< of its samples, mm; 0: chosen automatically
  std::optional<Eigen::Vector3d> part_at;           ///< of several separate parts judge by the one nearest to this place
  pcl_spiral::ClusterHandling clusters = pcl_spiral::ClusterHandling::Ride; ///< what clusters of points on the part are
};

/** Values behind the figures, mm; see DeviationEstimation and MaterialRemoval. */
struct Heights {
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr points; ///< of the scan, or the samples of the mesh
  std::vector<float> deviation;                    ///< one a path point
  std::vector<float> scallop;                      ///< one a path point: the ridge next to the nearest point of the scan; NaN: it has none
  std::vector<float> stock, ridges;                ///< one a point of the scan, or a sample of the mesh
};

/** The distance of \p path from \p scan, without a cutter: only the figures of deviation. \p reference is
 * the fit to the scan; it is made if it is null. Fails as DeviationEstimation does. */
pcl_spiral::Status judgeDeviation(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan,
                                  const pcl::PointCloud<pcl_spiral::ToolpathPoint>::ConstPtr& path, const JudgeSettings& settings,
                                  const pcl_spiral::ProgressCallback& progress,
                                  std::shared_ptr<const pcl_spiral::ReferenceSurface>& reference, pcl_spiral::Verification& verification,
                                  Heights& heights);

/** The figures of \p path against \p scan. \p reference is the fit to the scan; it is made if it is null,
 * and kept for the next path. Fails as DeviationEstimation and MaterialRemoval do. */
pcl_spiral::Status judgePath(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan,
                             const pcl::PointCloud<pcl_spiral::ToolpathPoint>::ConstPtr& path, const JudgeSettings& settings,
                             const pcl_spiral::ProgressCallback& progress, std::shared_ptr<const pcl_spiral::ReferenceSurface>& reference,
                             pcl_spiral::Verification& verification, Heights& heights);
