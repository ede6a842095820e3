// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Which points of a scan are the part to be machined.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/prism.h>
#include <pcl_spiral/surface/surface_settings.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/types.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** The part of a scan; everything else in the scan is an obstacle. Places in the coordinates of the scan, mm. */
struct PartChoice {
  std::optional<Eigen::Vector3d> part_at;             ///< a place on the part, of several separate ones
  std::optional<Eigen::AlignedBox3d> crop_box;        ///< only points inside are of the part
  std::optional<Prism> crop;                          ///< the same with a polygon
  std::optional<Prism> region;                        ///< the same once more: one of several regions inside the crop
  std::vector<Prism> keep_outs;                       ///< that the cutter does not enter
  double margin = 0.0;                                ///< how much farther from keep-outs than one point spacing the ball stays, mm
  ClusterHandling clusters = ClusterHandling::Refuse; ///< what to do with clusters of points that stand on the part

  /** Whether points are left out by their place. */
  bool cuts() const { return crop_box || crop || region || !keep_outs.empty(); }
};

/** One of several regions of a part, each with a path of its own: the points in the polygon, of the separate part at the place. */
struct PlanRegion {
  std::optional<Prism> polygon;           ///< absent: all that the crop leaves
  std::optional<Eigen::Vector3d> part_at; ///< absent: there is one part
  std::string name;                       ///< for messages; empty: "region 2"
};

/** A narrow strip of the part beside a keep-out that is left uncut, because no path was found with it. */
struct UncutStrip {
  Eigen::Vector3d place;               ///< of its point in the middle
  double width = 0.0;                  ///< that it is narrower than, mm
  double area = 0.0;                   ///< mm2
  pcl::Indices indices;                ///< of its points in the cloud that it was taken from, ascending
  std::vector<Eigen::Vector3f> points; ///< these points
};

/** What is left of a scan when the part is chosen. */
struct ChosenPart {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud; ///< its points; null: all of the scan
  pcl::PointCloud<pcl::Normal>::Ptr normals; ///< one for each of these points; null: the scan has none, or all points are left
  std::vector<Prism> keep_outs;              ///< as given
  std::vector<Eigen::Vector3f> beside;       ///< points left out by their place, without those in a keep-out
  std::vector<Eigen::Vector3f> kept_out;     ///< points in a keep-out
  std::optional<Eigen::Vector3d> part_at;    ///< as given
  std::vector<UncutStrip> strips;            ///< that are left uncut
  Diagnostics warnings;                      ///< what was left out
};

} // namespace pcl_spiral
