// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Judges a toolpath by a scan or a mesh.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/core/prism.h>
#include <pcl_spiral/core/setting.h>
#include <pcl_spiral/verify/deviation_estimation.h>
#include <pcl_spiral/verify/raw_scan.h>
#include <pcl_spiral/verify/verification.h>

#include <pcl/pcl_base.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Settings for judging a path. */
struct JudgeSettings {
  CutterShape cutter;                             ///< radius 0: not given
  Polyline tips;                                  ///< of the path, one per point; empty: from its contacts
  double scallop_height = 0.05;                   ///< that the path was made for, mm
  double chord_error = 0.005;                     ///< that the path was made for, mm
  pcl::PointCloud<pcl::Normal>::ConstPtr normals; ///< of the scan, one for each point; null: none
  std::optional<Eigen::Vector3d> view_point;      ///< of the scanner
  bool trust_normals = false;                     ///< see SurfaceSettings
  bool flip_normals = false;
  unsigned int threads = 0;
  bool largest_part = false;                        ///< of several separate parts judge by the largest
  Surface::ConstPtr surface;                        ///< of the scan, if it exists already; null: it is made
  SurfaceMesh::ConstPtr mesh = nullptr;             ///< to judge by instead of a scan; null: by the scan
  double sample_spacing = 0.0;                      ///< of its samples, mm; 0: chosen automatically
  std::optional<Eigen::Vector3d> part_at;           ///< of several separate parts judge by the one nearest to this place
  ClusterHandling clusters = ClusterHandling::Ride; ///< what clusters of points on the part are
};

/** Scallop height, chord error and sample spacing; the others are of the surface, see SurfaceSettings, or no values. */
std::vector<Setting> settingTable(JudgeSettings& settings);

/** Values behind the figures, mm; see DeviationEstimation and MaterialRemoval. */
struct Heights {
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr points; ///< of the scan, or the samples of the mesh
  std::vector<float> deviation;                    ///< one a path point
  std::vector<float> scallop;                      ///< one a path point: the ridge next to the nearest point of the scan; NaN: it has none
  std::vector<float> stock, ridges;                ///< one a point of the scan, or a sample of the mesh
};

/** The distance of \p path from \p scan, without a cutter: only the figures of deviation. \p reference is
 * the fit to the scan; it is made if it is null. Fails as DeviationEstimation does. */
Status judgeDeviation(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path,
                      const JudgeSettings& settings, const ProgressCallback& progress, std::shared_ptr<const ReferenceSurface>& reference,
                      Verification& verification, Heights& heights);

/** The figures of \p path against \p scan. \p reference is the fit to the scan; it is made if it is null,
 * and kept for the next path. Fails as DeviationEstimation and MaterialRemoval do. */
Status judgePath(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path,
                 const JudgeSettings& settings, const ProgressCallback& progress, std::shared_ptr<const ReferenceSurface>& reference,
                 Verification& verification, Heights& heights);

/** How far the tool axis leans from the normals of \p path, degrees: all but one point in a hundred lean less. */
double leanOf(const pcl::PointCloud<ToolpathPoint>& path);

/** What is wrong where the path cuts into the \p raw scan, deeper than \p allowed and the noise of its means. Empty: nothing. */
Diagnostic faultInRaw(const RawScanReport& raw, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path, const JudgeSettings& settings,
                      double allowed);

/** What a path must keep off, apart from the surface it is on. */
struct JudgedSurroundings {
  std::vector<Prism> keep_outs;                   ///< that the cutter does not enter
  std::vector<Eigen::Vector3f> kept_out;          ///< what stands in them
  std::vector<Eigen::Vector3f> beside;            ///< the scan beside what is cut; false echoes may be among it
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr whole; ///< the scan, which tells the false echoes; null: a mesh
};

/** What is wrong where the path meets the limits of the part: its cutter enters a keep-out, or cuts into what stands there, into the scan
 *  beside, into the parts that \p reference leaves out, or into a cluster that stands on it. Empty: nothing. \p settings: cutter and tips.
 *  \p allowed: depth of a cut that counts as none, mm. Adds to \p warnings where only false echoes beside the part are met. */
Diagnostics faultsBeside(const JudgedSurroundings& around, const Surface& reference, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path,
                         const JudgeSettings& settings, double allowed, Diagnostics& warnings);

/** Adds to \p verification of \p path the verdicts: limits broken and unproven, poses that are wrong, what the cutter meets \p around, and
 *  cuts into the \p raw scan, if it is not null. */
void addVerdicts(const Limits& limits, const JudgedSurroundings& around, const ReferenceSurface& reference,
                 const pcl::PointCloud<ToolpathPoint>::ConstPtr& path, const JudgeSettings& settings, const RawScanReport* raw,
                 const std::string& raw_name, Verification& verification);

/** Compares the \p raw scan with the \p smoothed surface; InvalidInput if most of its points are not near. */
Status compareRawScan(const pcl::PointCloud<pcl::PointXYZ>& raw, const Surface& smoothed, RawScanReport& figures);

} // namespace pcl_spiral
