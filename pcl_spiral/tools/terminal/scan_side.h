// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The outer side of a scan, from options and from its file: the same rule in all programs.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/graph/outer_side.h>
#include <pcl_spiral/io/cloud_reader.h>

#include <optional>
#include <string>

/** What decides the side of a scan. --view-point overrides the file; of the file, normals come before VIEWPOINT. */
struct ScanSide {
  pcl::PointCloud<pcl::Normal>::ConstPtr normals; ///< of the file; null: none, or overridden
  std::optional<Eigen::Vector3d> view_point;      ///< of the option, else of the file
  bool from_option = false;                       ///< the view point is that of the option
};

/** \p view_point is the value of --view-point, if it was given. */
ScanSide sideOf(const pcl_spiral::Scan& scan, const std::optional<Eigen::Vector3d>& view_point);

/** Sets normals and view point of a stage that takes a scan. */
template <typename Stage>
void
setSide(const ScanSide& side, Stage& stage)
{
  if (side.normals)
    stage.setInputNormals(side.normals);
  stage.setTrustNormals(false); // they come from a file: normals without a common side are not used, with a warning
  if (side.view_point)
    stage.setViewPoint(*side.view_point);
}

/** What decided the side, and whether it came from the file, in one line of a summary. */
std::string sideLine(const ScanSide& asked, const pcl_spiral::OuterSide& found);

/** A warning if the side is that of the default VIEWPOINT of an organised cloud, and +z would have given the other side; else empty. */
pcl_spiral::Diagnostics viewPointWarnings(const ScanSide& asked, const pcl_spiral::OuterSide& found);
